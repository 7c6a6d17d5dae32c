// View: what every pass of a frame knows of the camera and the air. View space is the camera's own:
// x right, y up, looking along -z, metres.
#pragma once
#include "shared/language.h"
SHARED_BEGIN

struct View {
    mat4 clipFromView;
    vec4 halfExtent;   // x, y: half the view at unit distance (perspective) or in metres; z: 1 where
                       // orthographic
    vec4 depthTerms;   // x, y: distance along -z = x / (depth - y), or x + y depth (orthographic);
                       // z: near, w: far, metres
    vec4 picture;      // width, height in pixels; their inverses
    vec4 haze;         // scattering, extinction in 1/m; the phase function's g and k
    vec4 upAmbient;    // xyz: world's up in view space; w: ambient illuminance, lux
    ivec4 lampCounts;  // spots, point lamps, directional lamps; 1 where there is an environment
    mat4 environment[3];  // by channel, in view space; see lib/environment.glsl
};

SHARED_END
