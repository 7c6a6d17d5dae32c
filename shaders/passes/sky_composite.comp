// The sky, the planet's ground and the sun behind everything, the air in front of surfaces, and the
// daylight that the stage's haze scatters. By the renderer's own tables, or with SKY_BASELINE by a
// model of the literature.
#include "passes/sky_block.glsl"
#include "lib/phase_function.glsl"
#include "lib/sun_disc.glsl"
#ifdef SKY_BASELINE
#include "passes/sky_baseline_seen.glsl"
#else
#include "passes/sky_seen.glsl"
#endif
#include "passes/sky_haze.glsl"
#include "shared/view.h"
#include "lib/haze.glsl"
#include "lib/view_ray.glsl"

layout(local_size_x = kSkyGroup, local_size_y = kSkyGroup) in;
layout(std140, binding = kViewSlot) uniform ViewBlock { View view; };
layout(binding = kDepthUnit) uniform sampler2D depthMap;
layout(rgba32f, binding = kColorUnit) uniform image2D colorMap;

#ifndef SKY_BASELINE
layout(binding = kSkyViewUnit) uniform sampler2DArray skyView;
layout(binding = kAerialUnit) uniform sampler2DArray aerial;
#ifdef SKY_EDGES
layout(std430, binding = kSkyEdgesSlot) readonly buffer Edges { uint edges[]; };
layout(std430, binding = kSkyEdgeTilesSlot) buffer EdgeTiles {
    SkyEdgeHead head;
    uint tiles[];
};

/// Whether a texel around a place in a half of the table is one of sky_edges.comp's.
bool isAtEdge(vec2 place, int half1) {
    uvec2 low = uvec2(min(place, vec2(kSkyViewAzimuths - 2, kSkyViewAngles - 2)));
    uint row = uint(kSkyEdgeWords) * (uint(half1 * kSkyViewAngles) + low.y);
    uint next = row + uint(kSkyEdgeWords);
    uvec2 columns = uvec2(low.x, low.x + 1u);
    uvec2 words = columns / 32u;
    uvec2 bits = uvec2(edges[row + words.x] | edges[next + words.x],
                       edges[row + words.y] | edges[next + words.y]) >> columns % 32u;
    return ((bits.x | bits.y) & 1u) != 0u;
}

void listTile(uvec2 at) {
    uint across = (uint(view.picture.x) + uint(kSkyGroup) - 1u) / uint(kSkyGroup);
    uint down = (uint(view.picture.y) + uint(kSkyGroup) - 1u) / uint(kSkyGroup);
    if (atomicExchange(tiles[across * down + at.y * across + at.x], 1u) == 0u) {
        uint slot = atomicAdd(head.count, 1u);
        tiles[slot] = at.x | at.y << 16;
        if (slot < uint(kMostSkyGroups)) {
            atomicAdd(head.groupsX, 1u);
        }
    }
}
#endif

/// For a sun of irradiance 1. `edge`: it is left out, to be summed up along this very ray.
vec3 seenSky(Air air, vec3 direction, OUT(bool) ground, OUT(bool) edge) {
    edge = false;
    float mu = dot(direction, sky.zenith.xyz);
    float nu = clamp(dot(direction, sky.sun.xyz), -1.0, 1.0);
    vec2 horizon = horizonPlace(air, sky.zenith.w);
    ground = mu < horizon.x;
    float sine = zenithSine(direction);
    float part = length(vec2(mu, sine) - horizon) /
                 length(endPlace(air, sky.zenith.w, ground) - horizon);
    if (part > 1.0 && !ground) {
        return vec3(0.0);
    }
    float u = rowOfPart(air, sky.zenith.w, ground, clamp(part, 0.0, 1.0));
    float azimuth = acos(skyAzimuthCosine(mu, sky.sun.w, nu)) * kInversePi;
    vec2 last = vec2(kSkyViewAzimuths - 1, kSkyViewAngles - 1);
    vec2 texel = vec2(columnOfAzimuth(azimuth), u) * last;
    vec2 uv = (texel + 0.5) / (last + 1.0);
    float layer = ground ? 2.0 : 0.0;
    float phase = phaseCornetteShanks(nu, air.mieG);
    vec3 light = fromSkyTexel(textureLod(skyView, vec3(uv, layer), 0.0).rgb) +
                 fromSkyTexel(textureLod(skyView, vec3(uv, layer + 1.0), 0.0).rgb) * phase;
#ifdef SKY_EDGES
    edge = isAtEdge(texel, ground ? 1 : 0);
    light = edge ? vec3(0.0) : light;
#endif
    return light;
}

#endif

/// The sun's disc through the air, for a sun of irradiance 1.
vec3 seenSun(Air air, vec3 direction) {
    float pixel = 2.0 * view.halfExtent.y * view.picture.w;
    vec3 disc = sunDisc(direction, sky.sun.xyz, atmosphere.sun.w, pixel);
    if (disc.g <= 0.0) {
        return disc;
    }
    vec4 ray = vec4(sky.zenith.w, dot(direction, sky.zenith.xyz), sky.sun.w, 1.0);
    float entry;
    bool inAir = intoAir(air, ray, zenithSine(direction), entry);
    return disc * (inAir ? sunTransmittance(air, ray.x, ray.y) : vec3(1.0));
}

/// Daylight that the haze scatters towards the eye over a way; neither is dimmed on its way in.
vec3 litHaze(vec3 direction, float metres) {
    vec3 around = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        around += sky.irradiance[i].rgb;
    }
    around = (around + 2.0 * sky.irradiance[4].rgb) / 6.0 * kInversePi;
    float phase = phaseFunction(PHASE_KIND, dot(direction, sky.sun.xyz), view.haze.z, view.haze.w);
    return view.haze.x * metres * oneMinusExpOver(view.haze.y * metres) *
           (sky.sunLux.rgb * phase + around);
}

#ifndef SKY_BASELINE
/// Dims `color` by the air in front of it and adds the air's light.
vec3 throughAir(Air air, vec3 color, vec2 uv, vec3 direction, float metres) {
    vec2 size = vec2(kAerialAcross, kAerialDown);
    vec2 place = (uv * (size - 1.0) + 0.5) / size;
    float depth = sqrt(clamp(metres / sky.aerial.x, 0.0, 1.0)) * float(kAerialDepths - 1);
    float low = min(floor(depth), float(kAerialDepths - 2));
    vec4 rest = mix(textureLod(aerial, vec3(place, low), 0.0),
                    textureLod(aerial, vec3(place, low + 1.0), 0.0), depth - low);
    low += float(kAerialDepths);
    vec4 mie = mix(textureLod(aerial, vec3(place, low), 0.0),
                   textureLod(aerial, vec3(place, low + 1.0), 0.0),
                   depth + float(kAerialDepths) - low);
    rest = exp(rest);
    mie = exp(mie);
    float nu = dot(direction, sky.sun.xyz);
    vec3 added = metres * (rest.rgb + mie.rgb * phaseCornetteShanks(nu, air.mieG));
    return color * airTransmittance(air, metres * rest.a, metres * mie.a) + added * atmosphere.sun.rgb;
}

#endif

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, ivec2(view.picture.xy)))) {
        return;
    }
    Air air = readAir();
    vec2 uv = (vec2(at) + 0.5) * view.picture.zw;
    vec3 origin = viewRayOrigin(2.0 * uv - 1.0, view.halfExtent);
    vec3 direction = viewRayDirection(2.0 * uv - 1.0, view.halfExtent);
    vec4 color = imageLoad(colorMap, at);
    float depth = texelFetch(depthMap, at, 0).r;
    if (depth > 0.0) {
        float metres = viewDistance(depth, view.depthTerms, view.halfExtent.z) / -direction.z;
        color.rgb = throughAir(air, color.rgb, uv, direction, metres) +
                    litHaze(direction, metresOfHaze(origin, direction, metres));
    } else {
        bool ground;
        bool edge;
        vec3 behind = seenSky(air, direction, ground, edge);
        if (!ground) {
            behind += seenSun(air, direction);
        }
        float metres = metresOfHaze(origin, direction, kEndOfHaze);
        float through = transmittance(view.haze.y, metres);
        behind = behind * atmosphere.sun.rgb * through + litHaze(direction, metres);
        // What is see-through has been drawn over black.
        color.rgb += (1.0 - color.a) * behind;
#ifdef SKY_EDGES
        if (edge && color.a < 1.0) {
            listTile(gl_WorkGroupID.xy);
        }
#endif
        // What has yet to be added stays see-through.
        color.a = edge ? color.a : 1.0;
    }
    imageStore(colorMap, at, color);
}
