// What a ray brings by Schuler's model, or with SKY_CHAPMAN_BETTER with the better form of Chapman's
// function; SKY_SEGMENTS segments.
#include "passes/sky_air.glsl"
#include "lib/phase_function.glsl"
#include "lib/chapman.glsl"
#include "lib/sky_chapman.glsl"

#ifdef SKY_CHAPMAN_BETTER
const bool kBetter = true;
#else
const bool kBetter = false;
#endif

/// What is left of sunlight at a height 0..top, and of that of the disc.
vec3 sunlightAt(Air air, float h, float muS) {
    return chapmanSunlight(air, h, muS, kBetter);
}
vec3 sunTransmittance(Air air, float h, float muS) {
    return sunlightAt(air, h, muS);
}

/// Irradiance of level planes by the sky alone: light scattered once knows none.
vec3 skylightAt(Air air, float h, float muS) {
    return vec3(0.0);
}

/// Irradiance of the ground.
vec3 groundIrradiance(Air air, float muS) {
    return sunlightAt(air, 0.0, muS) * max(muS, 0.0);
}

/// `start`: height, mu, muS, nu. A ray that is cut is marched as any other.
void skyAlong(Air air, vec4 start, float length1, bool ground, bool cut, OUT(vec3) transmittance,
              OUT(vec3) light) {
    float there = clamp(heightAlong(air, start.x, start.y, length1), 0.0, air.top);
    float muThere = cosineAlong(air, start.x, start.y, length1, there);
    transmittance = chapmanTransmittance(
        air, chapmanBetween(air, start.x, start.y, there, muThere, ground, kBetter));
    light = chapmanLight(air, start.x, start.y, start.z, start.w, length1, ground, SKY_SEGMENTS,
                         kBetter);
}
