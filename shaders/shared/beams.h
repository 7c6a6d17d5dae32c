// What the beam passes add to the view.
#pragma once
#include "shared/language.h"
SHARED_BEGIN

const int kTileSide = 16;         // pixels
const int kLatticeStep = 4;       // pixels from one point of the lattice to the next; a cell's side
const int kTileCellsAcross = kTileSide / kLatticeStep;
const int kTileCells = kTileCellsAcross * kTileCellsAcross;
const int kCellPixels = kLatticeStep * kLatticeStep;
const int kBeamGroup = 64;  // invocations of a work group
const int kCellsAGroup = kBeamGroup / kCellPixels;  // sampled by one work group at a time
const int kMaxBeamGroups = 65535;  // as many as any OpenGL dispatches; each goes on until all is done
const float kEndOfBeams = 1.0e5F;  // metres along the view axis, where nothing ends a beam before

struct BeamTile {
    ivec4 place;  // x, y in tiles; first entry and number of entries in the list of lamps
    ivec4 detail; // x: 1 where a beam is so thin that it may pass between lattice points
};

struct BeamSettings {
    vec4 planes;    // number; first depth, spacing (metres along the view axis); weight of a step in
                    // metres along the view axis
    ivec4 cells;    // cells across and down for the smooth factor, 0: evaluated at every pixel
    ivec4 lattice;  // points across and down; tiles
    vec4 adaptive;  // how far interpolation may be off what the screen shows, 0..1
};

// What the shadow maps' pyramid told of the runs of sheets it was asked about, and the sheets whose
// texel was then looked at.
struct RunCounts {
    uint mixed;
    uint dark;
    uint lit;
    uint fetches;
};

// The list of cells to sample, as an indirect dispatch reads it.
struct SampledCellsHead {
    uint groupsX;
    uint groupsY;
    uint groupsZ;
    uint count;
};

SHARED_END
