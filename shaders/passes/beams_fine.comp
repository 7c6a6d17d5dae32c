// Beams, method `adaptive`, third step: the finer lattice's points in the listed cells, sampled like the
// lattice.
#include "passes/beams_sheets.glsl"
#include "lib/beam_lattice.glsl"

layout(local_size_x = kListGroup * kNewPoints) in;
layout(std430, binding = kSampledCellsSlot) readonly buffer SampledCells { SampledHead sampled; BeamSquare cells[]; };
layout(rgba32f, binding = kBeamFineUnit) uniform writeonly image2D fineMap;

void drawPoint(ivec4 cell, int index) {
    ivec2 point = cell.xy * kCellQuadsAcross + newPoint(index);
    ivec2 pixel = min(point * kFineStep, ivec2(view.picture.xy) - 1);
    float beamEnd = 0.0;
    vec3 sum = beamsRadiance(pixelRay(pixel), cell.zw, beamEnd);
    imageStore(fineMap, point, vec4(sum, beamEnd));
}

void main() {
    int entry = int(gl_GlobalInvocationID.x) / kNewPoints;
    int index = int(gl_GlobalInvocationID.x) % kNewPoints;
    int count = int(sampled.count);
    do {
        if (entry < count) {
            drawPoint(cells[entry].place, index);
        }
        entry += int(gl_NumWorkGroups.x) * kListGroup;
    } while (entry < count);
}
