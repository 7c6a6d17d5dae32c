// What the beam passes add to the view.
#pragma once
#include "shared/language.h"
SHARED_BEGIN

const int kTileSide = 16;         // pixels; of tiles that are drawn as squares, each of them some work
const int kLatticeTileSide = 8;   // of those whose points are gone through: fewer lamps that miss them
const int kLatticeStep = 4;       // pixels from one point of the lattice to the next; a cell's side
const int kFineStep = 2;          // the same in the cells that are looked at closer; a quad's side
const int kTileCellsAcross = kLatticeTileSide / kLatticeStep;
const int kTileCells = kTileCellsAcross * kTileCellsAcross;
const int kCellQuadsAcross = kLatticeStep / kFineStep;
const int kCellQuads = kCellQuadsAcross * kCellQuadsAcross;
const int kNewPoints = 3;   // that halving the step adds to a cell or quad, whose own is known
const int kBeamGroup = 64;  // invocations of a work group that goes through the tiles
const int kListGroup = 32;  // entries of a list of cells or quads that a work group takes
const int kMaxBeamGroups = 65535;  // as many as any OpenGL dispatches; each goes on until all is done
const float kEndOfBeams = 1.0e5F;  // metres along the view axis, where nothing ends a beam before

// A square of the picture that beams cover: a tile, or a cell or quad in one.
struct BeamSquare {
    ivec4 place;  // x, y in sides of the square; first entry and number of entries in the list of lamps
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

// Before a list of squares to sample: what an indirect dispatch reads, and how many there are.
struct SampledHead {
    uint groupsX;
    uint groupsY;
    uint groupsZ;
    uint count;
};

SHARED_END
