// Which of the literature's models a program has: with SKY_PRECOMPUTED tables, otherwise the one
// without. Either has skyAlong() and groundIrradiance(), and here what the sun and the sky light a
// scene with.
#include "passes/sky_block.glsl"
#include "lib/phase_function.glsl"
#ifdef SKY_PRECOMPUTED
#include "passes/sky_lookup.glsl"
#include "passes/sky_precomputed.glsl"
#else
#include "passes/sky_chapman.glsl"
#endif

/// What is left of sunlight at a height 0..top.
vec3 sunlightAt(Air air, float h, float muS) {
#ifdef SKY_PRECOMPUTED
    return transmittanceToSun(air, h, muS);
#else
    return chapmanSunlight(air, h, muS, kBetter);
#endif
}

/// Irradiance of level ground by the sky alone; models of light scattered once know none.
vec3 skylightAt(Air air, float h, float muS) {
#if defined(SKY_PRECOMPUTED) && !defined(SKY_2008)
    return irradianceAt(air, h, muS);
#else
    return vec3(0.0);
#endif
}
