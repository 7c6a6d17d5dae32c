// What listed rays bring by a model that has skyAlong() and groundIrradiance().
#include "shared/sky.h"
#include "lib/pi.glsl"

layout(local_size_x = kSkyRayGroup) in;
layout(std430, binding = kSkyRaysSlot) readonly buffer Rays { SkyRayStart rays[]; };
layout(std430, binding = kSkyLightsSlot) writeonly buffer Lights { SkyRayLight lights[]; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= uint(rays.length())) {
        return;
    }
    Air air = readAir();
    vec4 ray = rays[index].ray;
    vec4 way = rays[index].way;
    bool ground = way.y > 0.5;
    bool onGround = way.z > 0.5;
    // Whether anything of the air lies behind the ray's end; its length was found in doubles.
    bool cut = ground ? !onGround : way.x < 0.99999 * distanceToTop(air, ray.x, ray.y);
    vec3 transmittance;
    vec3 light;
    skyAlong(air, ray, way.x, ground, cut, transmittance, light);
    vec3 reflected = vec3(0.0);
    if (onGround) {
        float muS = sunCosineAlong(air, ray.x, ray.z, ray.w, way.x, 0.0);
        reflected = transmittance * atmosphere.albedo.rgb / kPi * groundIrradiance(air, muS);
    }
    lights[index].transmittance = vec4(transmittance, 1.0);
    lights[index].air = vec4(light, 0.0);
    lights[index].ground = vec4(reflected, 0.0);
}
