// A planet's air, ground and sun as the sky's shaders see them, whatever model draws the sky.
#pragma once
#include "shared/language.h"
SHARED_BEGIN

// Metres. Colours are per linear sRGB channel; coefficients, in 1/m, those at the ground.
struct Atmosphere {
    vec4 rayleigh;       // scattering; w: scale height
    vec4 mieScattering;  // w: scale height
    vec4 mieExtinction;  // w: asymmetry g of Cornette and Shanks
    vec4 shell;          // radius of the ground; height of the air's top above it
    vec4 albedo;         // of the ground, 0..1
    vec4 sun;            // lux at the top; w: its radius in radians
};

SHARED_END
