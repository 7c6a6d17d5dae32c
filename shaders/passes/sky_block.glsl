// What every pass that draws a sky knows of the frame, whatever model draws it, and where a view ray
// meets the air.
#include "passes/sky_air.glsl"
#include "shared/sky.h"
#include "lib/pi.glsl"

layout(std140, binding = kSkySlot) uniform SkyBlock { SkyFrame sky; };

/// Sine of the angle between a view direction and the zenith, as exact where that is small.
float zenithSine(vec3 direction) {
    return length(cross(direction, sky.zenith.xyz));
}

/// Moves a ray of any height to where it is in the air; false where it passes it by. `sine` is of
/// its angle from the zenith.
bool intoAir(Air air, inout vec4 ray, float sine, OUT(float) entry) {
    entry = 0.0;
    if (ray.x <= air.top) {
        return true;
    }
    float mu;
    float muS;
    bool hit = enterAir(air, ray.x, ray.y, sine, ray.z, ray.w, entry, mu, muS);
    ray = vec4(air.top, mu, muS, ray.w);
    return hit;
}
