// The sky's light along listed rays, by the functions that draw it.
#include "passes/sky_radiance.glsl"

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
    vec2 lengths = lengthsAlong(air, ray.x, ray.y, way.x, way.y > 0.5);
    vec3 through = airTransmittance(air, lengths.x, lengths.y);
    SkyLight light = marchSky(air, ray, way.x);
    vec3 sum = light.rayleigh * phaseRayleigh(ray.w) +
               light.mie * phaseCornetteShanks(ray.w, air.mieG) + light.later;
    lights[index].transmittance = vec4(through, 1.0);
    lights[index].air = vec4(sum, 0.0);
    lights[index].ground =
        vec4(way.z > 0.5 ? groundLight(air, ray, way.x, through) : vec3(0.0), 0.0);
}
