// What the sky's passes know of a frame, and the rays that are asked for one by one.
#pragma once
#include "shared/language.h"
SHARED_BEGIN

const int kSkyGroup = 8;         // invocations of a work group each way
const int kSkyRayGroup = 64;     // of one that goes through a list of rays
const int kMostSkyGroups = 65535; // of a list
const int kSkyViewAzimuths = 56; // the table of what is seen from the eye's height
const int kSkyViewAngles = 76;   // above the horizon, and as many below
const int kSkyEdgeWords = 2;     // of 32 bits, for a row's columns
const int kAerialAcross = 24;    // the table of the air in front of surfaces
const int kAerialDown = 32;
const int kAerialDepths = 20;

struct SkyFrame {
    mat4 worldFromView;
    vec4 zenith;         // at the eye, view space, unit; w: the eye's height in metres
    vec4 sun;            // towards it, view space, unit; w: cosine to the zenith at the eye
    vec4 sunward;        // the same made level where the scene stands
    vec4 suns;           // scale, first, last of the suns that sources are tabulated for
    vec4 aerial;         // farthest distance of the air's table, metres
    vec4 hazeMiddle;     // of the haze's cloud, world
    vec4 hazePerMetre;   // one over where it has thinned out to 1 / e; w: 1 where there is any
    vec4 sunLux;         // where the scene stands
    vec4 irradiance[5];  // lux by sky and ground there: looking up, down, to the sun, away, across
};

struct SkyRayStart {
    vec4 ray;  // height in metres, mu, muS, nu where it enters the air
    vec4 way;  // metres within the air; 1 where the endless ray hits the ground; 1 where it ends there
};

struct SkyRayLight {
    vec4 transmittance;
    vec4 air;     // for a sun of irradiance 1
    vec4 ground;
};

// What a list of the picture's tiles begins with: its work groups, and how many tiles it holds. It
// goes on with the tiles (column, and row in the upper 16 bits), as many as there are, and for each
// whether it is listed.
struct SkyEdgeHead {
    uint groupsX;
    uint groupsY;
    uint groupsZ;
    uint count;
};

SHARED_END
