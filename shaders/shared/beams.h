// What the beam passes add to the view.
#pragma once
#include "shared/language.h"
SHARED_BEGIN

const int kTileSide = 16;         // pixels
const float kEndOfBeams = 1.0e5F;  // metres along the view axis, where nothing ends a beam before

struct BeamTile {
    ivec4 place;  // x, y in tiles; first entry and number of entries in the list of lamps
};

struct BeamSettings {
    vec4 planes;    // number; first depth, spacing (metres along the view axis); weight of a step in
                    // metres along the view axis
    ivec4 cells;    // cells across and down for the smooth factor, 0: evaluated at every pixel
};

SHARED_END
