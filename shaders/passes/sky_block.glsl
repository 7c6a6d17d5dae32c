// What every pass that draws a sky knows of the frame, whatever model draws it, and where a view ray
// meets the air.
#include "passes/sky_air.glsl"
#include "shared/sky.h"
#include "lib/pi.glsl"

layout(std140, binding = kSkySlot) uniform SkyBlock { SkyFrame sky; };

/// Moves a ray of any height to where it is in the air; false where it passes it by.
bool intoAir(Air air, inout vec4 ray, OUT(float) entry) {
    entry = 0.0;
    if (ray.x <= air.top) {
        return true;
    }
    float mu;
    float muS;
    bool hit = enterAir(air, ray.x, ray.y, ray.z, ray.w, entry, mu, muS);
    ray = vec4(air.top, mu, muS, ray.w);
    return hit;
}
