// The sky and the planet's ground as seen from the eye's height under the sun at hand, for all
// directions. Layers: light but for what Mie's air scattered once, and that without its phase
// function (alpha: that function); of the upper half, then of the lower.
#include "passes/sky_seen.glsl"

layout(local_size_x = kSkyGroup, local_size_y = kSkyGroup) in;
layout(rgba32f, binding = kSkyTableUnit) uniform writeonly image2DArray skyView;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (at.x >= kSkyViewAzimuths || at.y >= kSkyViewAngles) {
        return;
    }
    bool ground = gl_GlobalInvocationID.z == 1u;
    Air air = readAir();
    float u = float(at.y) / float(kSkyViewAngles - 1);
    float h = sky.zenith.w;
    vec2 horizon = horizonPlace(air, h);
    float span = length(endPlace(air, h, ground) - horizon);
    vec2 place = placeFromHorizon(horizon, span * partOfRow(air, h, ground, u), ground);
    float mu = clamp(place.x, -1.0, 1.0);
    float muS = sky.sun.w;
    float cosAzimuth = cos(kPi * azimuthOfColumn(float(at.x) / float(kSkyViewAzimuths - 1)));
    float sines = place.y * sqrt(max((1.0 - muS) * (1.0 + muS), 0.0));
    vec4 ray = vec4(h, mu, muS, clamp(mu * muS + sines * cosAzimuth, -1.0, 1.0));

    SeenLight seen = seenAlong(air, ray, place.y, ground);
    int layer = ground ? 2 : 0;
    imageStore(skyView, ivec3(at, layer), vec4(skyTexel(seen.rest), 0.0));
    imageStore(skyView, ivec3(at, layer + 1),
               vec4(skyTexel(seen.mie), phaseCornetteShanks(ray.w, air.mieG)));
}
