// Beams, method `adaptive`, last step: the pixels of the listed cells, sampled like the lattice.
#include "passes/beams_sheets.glsl"

layout(local_size_x = kBeamGroup) in;
layout(std430, binding = kSampledCellsSlot) readonly buffer SampledCells { SampledCellsHead sampled; ivec4 cells[]; };
layout(rgba32f, binding = kColorUnit) uniform image2D colorMap;
#ifdef BEAMS_OUTPUT
layout(rgba32f, binding = kBeamsOutputUnit) uniform writeonly image2D beamsMap;
#endif

void drawPixel(ivec4 cell, int place) {
    ivec2 pixel = cell.xy * kLatticeStep + ivec2(place % kLatticeStep, place / kLatticeStep);
    if (pixel.x >= int(view.picture.x) || pixel.y >= int(view.picture.y)) {
        return;
    }
    float beamEnd = 0.0;
    vec4 sum = vec4(beamsRadiance(pixelRay(pixel), cell.zw, beamEnd), 0.0);
    imageStore(colorMap, pixel, imageLoad(colorMap, pixel) + sum);
#ifdef BEAMS_OUTPUT
    imageStore(beamsMap, pixel, sum);
#endif
}

void main() {
    int entry = int(gl_GlobalInvocationID.x) / kCellPixels;
    int place = int(gl_GlobalInvocationID.x) % kCellPixels;
    int count = int(sampled.count);
    do {
        if (entry < count) {
            drawPixel(cells[entry], place);
        }
        entry += int(gl_NumWorkGroups.x) * kCellsAGroup;
    } while (entry < count);
}
