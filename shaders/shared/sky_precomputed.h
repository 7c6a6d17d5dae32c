// What a precomputed sky's passes know of its tables beside their sizes.
#pragma once
#include "shared/language.h"
SHARED_BEGIN

struct PrecomputedSky {
    vec4 scattering;  // texels along the sun's cosine, mu, the height, nu
    vec4 suns;        // x: cosine of the lowest sun that is told from lower ones
};

SHARED_END
