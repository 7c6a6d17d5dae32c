// Where the table of what is seen bends too much from one texel to the next to be interpolated, as at
// the edge of the planet's shadow: a bit for each texel of a half, rows of kSkyEdgeWords words. Such
// places are summed up pixel by pixel (sky_edge_tiles.comp).
#include "passes/sky_seen.glsl"

layout(local_size_x = kSkyGroup, local_size_y = kSkyGroup) in;
layout(binding = kSkyViewUnit) uniform sampler2DArray skyView;
layout(std430, binding = kSkyEdgesSlot) buffer Edges { uint edges[]; };  // zero before

/// What may be off: a part of the light, a part of the brightest there is, and a moonless night's.
const float kOff = 0.02;
const float kOffOfBrightest = 3.0e-4;
const float kOffOfNight = 1.0e-9;

const int kEvery = 4;  // texels looked at for the brightest, each way

shared float brightest[kSkyGroup * kSkyGroup];

struct Bend {
    vec3 light;
    vec3 off;
};

/// How far off straight lines between three texels' logarithms are at most, about.
Bend bendOf(ivec2 before, ivec2 at, ivec2 after, int layer) {
    vec3 first = texelFetch(skyView, ivec3(before, layer), 0).rgb;
    vec3 middle = texelFetch(skyView, ivec3(at, layer), 0).rgb;
    vec3 last = texelFetch(skyView, ivec3(after, layer), 0).rgb;
    vec3 second = abs(first - 2.0 * middle + last);
    Bend bend;
    bend.light = fromSkyTexel(max(max(first, middle), last));
    bend.off = bend.light * (1.0 - exp(-0.125 * second));
    return bend;
}

float lightAt(ivec2 at, int layer) {
    vec4 mie = texelFetch(skyView, ivec3(at, layer + 1), 0);
    vec3 light = fromSkyTexel(texelFetch(skyView, ivec3(at, layer), 0).rgb) +
                 fromSkyTexel(mie.rgb) * mie.a;
    return max(max(light.r, light.g), light.b);
}

/// Of all of the table, as every group finds it.
float findBrightest() {
    uint self = gl_LocalInvocationIndex;
    float found = 0.0;
    int across = kSkyViewAzimuths / kEvery;
    int count = across * (kSkyViewAngles / kEvery);
    for (int i = int(self); i < 2 * count; i += kSkyGroup * kSkyGroup) {
        ivec2 at = kEvery * ivec2(i % count % across, i % count / across);
        found = max(found, lightAt(at, i < count ? 0 : 2));
    }
    brightest[self] = found;
    barrier();
    for (int i = 0; i < kSkyGroup * kSkyGroup; ++i) {
        found = max(found, brightest[i]);
    }
    return found;
}

bool isOff(Bend rest, Bend mie, float phase, float least) {
    vec3 off = rest.off + phase * mie.off;
    vec3 light = rest.light + phase * mie.light;
    return any(greaterThan(off, kOff * light + least));
}

void main() {
    float least = kOffOfBrightest * findBrightest() + kOffOfNight;
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (at.x >= kSkyViewAzimuths || at.y >= kSkyViewAngles) {
        return;
    }
    int layer = int(gl_GlobalInvocationID.z) * 2;
    // Azimuths go on beyond both ends as they came, rows end.
    int last = kSkyViewAzimuths - 1;
    ivec2 left = ivec2(at.x > 0 ? at.x - 1 : 1, at.y);
    ivec2 right = ivec2(at.x < last ? at.x + 1 : last - 1, at.y);
    int row = clamp(at.y, 1, kSkyViewAngles - 2);
    ivec2 middle = ivec2(at.x, row);
    ivec2 down = ivec2(at.x, row - 1);
    ivec2 up = ivec2(at.x, row + 1);
    float phase = texelFetch(skyView, ivec3(at, layer + 1), 0).a;
    bool off = isOff(bendOf(left, at, right, layer), bendOf(left, at, right, layer + 1), phase,
                     least) ||
               isOff(bendOf(down, middle, up, layer), bendOf(down, middle, up, layer + 1), phase,
                     least);
    if (off) {
        uint row = gl_GlobalInvocationID.z * uint(kSkyViewAngles) + uint(at.y);
        atomicOr(edges[uint(kSkyEdgeWords) * row + uint(at.x) / 32u], 1u << (uint(at.x) % 32u));
    }
}
