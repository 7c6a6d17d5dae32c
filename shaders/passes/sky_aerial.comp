// The air in front of surfaces: for places in the picture and distances, even in their square root,
// the light it adds and its optical lengths, each for a metre of the way so that they change little
// from one place to the next and vanish at the eye; as logarithms, since air thins out so. Layers:
// light but for what Mie's air scattered once (alpha: Rayleigh's length), and that without its phase
// function (alpha: Mie's length).
#include "passes/sky_seen.glsl"
#include "shared/view.h"
#include "lib/view_ray.glsl"

layout(local_size_x = kSkyGroup, local_size_y = kSkyGroup) in;
layout(std140, binding = kViewSlot) uniform ViewBlock { View view; };
layout(rgba32f, binding = kSkyTableUnit) uniform writeonly image2DArray aerial;

void main() {
    ivec3 at = ivec3(gl_GlobalInvocationID);
    if (at.x >= kAerialAcross || at.y >= kAerialDown) {
        return;
    }
    Air air = readAir();
    vec2 ndc = 2.0 * vec2(at.xy) / vec2(kAerialAcross - 1, kAerialDown - 1) - 1.0;
    vec3 direction = viewRayDirection(ndc, view.halfExtent);
    float part = max(float(at.z), 0.1) / float(kAerialDepths - 1);
    float distanceMetres = sky.aerial.x * part * part;
    vec4 ray = vec4(sky.zenith.w, dot(direction, sky.zenith.xyz), sky.sun.w,
                    dot(direction, sky.sun.xyz));
    vec4 rest = vec4(0.0);
    vec4 mie = vec4(0.0);
    float entry;
    if (intoAir(air, ray, zenithSine(direction), entry) && entry < distanceMetres) {
        float way = min(distanceMetres - entry, distanceToTop(air, ray.x, ray.y));
        SkyLight light = marchSky(air, ray, way);
        rest = vec4(light.rayleigh * phaseRayleigh(ray.w) + light.later, light.lengths.x);
        mie = vec4(light.mie, light.lengths.y);
    }
    imageStore(aerial, ivec3(at.xy, at.z), log(max(rest / distanceMetres, kDarkest)));
    imageStore(aerial, ivec3(at.xy, at.z + kAerialDepths),
               log(max(mie / distanceMetres, kDarkest)));
}
