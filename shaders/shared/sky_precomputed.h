// The sizes of a precomputed sky's tables as its passes see them.
#pragma once
#include "shared/language.h"
SHARED_BEGIN

// Counts of texels.
struct PrecomputedSky {
    vec4 scattering;  // along the sun's cosine, mu, the height, nu
    vec4 planes;      // transmittance: along mu, the height; irradiance: the sun's cosine, the height
    vec4 suns;        // x: cosine of the lowest sun that is told from lower ones
};

SHARED_END
