// Listed rays by the sky without tables, with the functions that draw it.
#include "passes/sky_chapman.glsl"
#include "passes/sky_baseline_points.glsl"
