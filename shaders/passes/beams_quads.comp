// Beams, method `adaptive`, fourth step: lists the quads of the listed cells that interpolation does not
// fill well enough.
#include "shared/slots.h"
#include "shared/beams.h"

layout(local_size_x = kListGroup * kCellQuads) in;
layout(std430, binding = kSampledCellsSlot) readonly buffer SampledCells { SampledHead sampledCells; BeamSquare cells[]; };
layout(std430, binding = kSampledQuadsSlot) buffer SampledQuads { SampledHead sampled; BeamSquare quads[]; };
layout(binding = kBeamFineUnit) uniform sampler2D pointMap;
layout(r8, binding = kBeamQuadsUnit) uniform writeonly image2D quadsMap;
const int kStep = kFineStep;
#include "passes/beams_judge.glsl"

void judgeQuad(BeamSquare cell, int place) {
    ivec2 quad = cell.place.xy * kCellQuadsAcross +
                 ivec2(place % kCellQuadsAcross, place / kCellQuadsAcross);
    if (quad.x >= pointCount().x || quad.y >= pointCount().y) {
        return;
    }
    if (cell.detail.x != 0 || !isWholeSquare(quad, pointCount()) || needsSamples(quad)) {
        imageStore(quadsMap, quad, vec4(1.0));
        uint slot = atomicAdd(sampled.count, 1u);
        quads[slot].place = ivec4(quad, cell.place.zw);
        if (slot % uint(kListGroup) == 0u && slot < uint(kMaxBeamGroups * kListGroup)) {
            atomicAdd(sampled.groupsX, 1u);
        }
    }
}

void main() {
    int entry = int(gl_GlobalInvocationID.x) / kCellQuads;
    int place = int(gl_GlobalInvocationID.x) % kCellQuads;
    int count = int(sampledCells.count);
    do {
        if (entry < count) {
            judgeQuad(cells[entry], place);
        }
        entry += int(gl_NumWorkGroups.x) * kListGroup;
    } while (entry < count);
}
