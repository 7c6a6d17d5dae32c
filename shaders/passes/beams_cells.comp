// Beams, method `adaptive`, second step: lists the cells that interpolation does not fill well enough,
// and interpolates the finer lattice's points in the others.
#include "shared/slots.h"
#include "shared/beams.h"

layout(local_size_x = kBeamGroup) in;
layout(std430, binding = kTilesSlot) readonly buffer Tiles { BeamSquare tiles[]; };
layout(std430, binding = kSampledCellsSlot) buffer SampledCells { SampledHead sampled; BeamSquare cells[]; };
layout(binding = kBeamLatticeUnit) uniform sampler2D pointMap;
layout(rgba32f, binding = kBeamFineUnit) uniform writeonly image2D fineMap;
const int kStep = kLatticeStep;
#include "passes/beams_judge.glsl"

void judgeCell(BeamSquare tile, int place) {
    ivec2 cell = tile.place.xy * kTileCellsAcross +
                 ivec2(place % kTileCellsAcross, place / kTileCellsAcross);
    if (cell.x >= pointCount().x || cell.y >= pointCount().y) {
        return;
    }
    ivec2 low = cell * kCellQuadsAcross;
    vec4 p00 = point(cell);
    imageStore(fineMap, low, p00);
    if (tile.detail.x != 0 || !isWholeSquare(cell, pointCount()) || needsSamples(cell)) {
        uint slot = atomicAdd(sampled.count, 1u);
        cells[slot].place = ivec4(cell, tile.place.zw);
        cells[slot].detail = tile.detail;
        if (slot % uint(kListGroup) == 0u && slot < uint(kMaxBeamGroups * kListGroup)) {
            atomicAdd(sampled.groupsX, 1u);
        }
    } else {
        vec4 p10 = point(cell + ivec2(1, 0));
        vec4 p01 = point(cell + ivec2(0, 1));
        vec4 p11 = point(cell + ivec2(1, 1));
        imageStore(fineMap, low + ivec2(1, 0), 0.5 * (p00 + p10));
        imageStore(fineMap, low + ivec2(0, 1), 0.5 * (p00 + p01));
        imageStore(fineMap, low + ivec2(1, 1), 0.25 * (p00 + p10 + p01 + p11));
    }
}

void main() {
    int cell = int(gl_GlobalInvocationID.x);
    int count = settings.lattice.z * kTileCells;
    do {
        if (cell < count) {
            judgeCell(tiles[cell / kTileCells], cell % kTileCells);
        }
        cell += int(gl_NumWorkGroups.x) * kBeamGroup;
    } while (cell < count);
}
