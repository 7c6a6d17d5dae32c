// Which of the literature's models a program has: with SKY_PRECOMPUTED tables, otherwise the one
// without. Either has skyAlong() and, for what the sun and the sky light a scene with,
// groundIrradiance(), sunTransmittance(), sunlightAt() and skylightAt().
#include "passes/sky_block.glsl"
#include "lib/phase_function.glsl"
#ifdef SKY_PRECOMPUTED
#include "passes/sky_lookup.glsl"
#include "passes/sky_precomputed.glsl"
#else
#include "passes/sky_chapman.glsl"
#endif
