// Where the shadow maps of the sun lie in the view.
#pragma once
#include "shared/language.h"
SHARED_BEGIN

const int kSunCascades = 6;

// The sun's frame is view space turned so that z points to the sun; metres.
struct SunShadow {
    mat4 sunFromView;
    vec4 cascades[kSunCascades];  // middle of the face away from the sun, from the eye; half the side
    vec4 depths[kSunCascades];    // 1 / the map's depth towards the sun; metres of a texel
    vec4 sun;                     // tan of its angular radius
    ivec4 counts;                 // cascades; texels of a map's side; texels of its margin
};

SHARED_END
