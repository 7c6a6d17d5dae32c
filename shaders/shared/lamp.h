// Lamps as the shaders see them, in view space. A spot's own frame has its apex at 0, x to the right
// and y up as seen from the lamp, z the depth along the beam.
#pragma once
#include "shared/language.h"
SHARED_BEGIN

struct SpotLamp {
    mat4 lampFromView;
    vec4 candela;     // R, G, B: colour * intensity; w: 1 / range in 1/m, 0 where infinite
    vec4 cone;        // cos inner, cos outer, cos^2 outer, sin^2 outer
    vec4 projection;  // 1 / tan outer; cos, sin of the light map's rotation; 1 where a pyramid
    vec4 shadow;      // 1 / tan of the shadow map's half angle; its near plane in metres; the size of a
                      // texel at unit depth; side in texels
    vec4 towardsEye;  // R, G, B: what the planet's air leaves of the beam's light on its way there
    ivec4 layers;     // shadow map, light map (-1: none); side of the light map in texels
};

// The cone around a spot's beam, square ones included: enough to tell which points it misses.
struct SpotCone {
    vec4 apex;  // view space; w: cos^2 of its half angle
    vec4 axis;  // unit, the way it shines
};

struct PointLamp {
    vec4 position;  // view space; w: 1 / range
    vec4 candela;   // R, G, B
};

struct DirectionalLamp {
    vec4 towardsLamp;  // unit, view space
    vec4 lux;          // R, G, B
};

SHARED_END
