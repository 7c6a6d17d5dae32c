// What a model of the literature lights a scene with: for each ray, which looks at the sun, the part
// of sunlight that is left at its start and the irradiance of level ground by the sky.
#include "passes/sky_baseline.glsl"

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
    lights[index].transmittance = vec4(sunlightAt(air, ray.x, ray.z), 1.0);
    lights[index].air = vec4(skylightAt(air, ray.x, ray.z), 0.0);
    lights[index].ground = vec4(0.0);
}
