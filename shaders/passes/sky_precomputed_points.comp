// Listed rays by a precomputed sky, with the functions that draw it.
#include "passes/sky_lookup.glsl"
#include "passes/sky_precomputed.glsl"
#include "passes/sky_baseline_points.glsl"
