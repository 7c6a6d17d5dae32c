// Beams, method `adaptive`, last step: the pixels of the listed quads, sampled like the lattice.
#include "passes/beams_sheets.glsl"
#include "lib/beam_lattice.glsl"

layout(local_size_x = kListGroup * kNewPoints) in;
layout(std430, binding = kSampledQuadsSlot) readonly buffer SampledQuads { SampledHead sampled; BeamSquare quads[]; };
layout(rgba32f, binding = kColorUnit) uniform image2D colorMap;
#ifdef BEAMS_OUTPUT
layout(rgba32f, binding = kBeamsOutputUnit) uniform writeonly image2D beamsMap;
#endif

void drawPixel(ivec4 quad, int index) {
    ivec2 pixel = quad.xy * kFineStep + newPoint(index);
    if (pixel.x >= int(view.picture.x) || pixel.y >= int(view.picture.y)) {
        return;
    }
    float beamEnd = 0.0;
    vec4 sum = vec4(beamsRadiance(pixelRay(pixel), quad.zw, beamEnd), 0.0);
    imageStore(colorMap, pixel, imageLoad(colorMap, pixel) + sum);
#ifdef BEAMS_OUTPUT
    imageStore(beamsMap, pixel, sum);
#endif
}

void main() {
    int entry = int(gl_GlobalInvocationID.x) / kNewPoints;
    int index = int(gl_GlobalInvocationID.x) % kNewPoints;
    int count = int(sampled.count);
    do {
        if (entry < count) {
            drawPixel(quads[entry].place, index);
        }
        entry += int(gl_NumWorkGroups.x) * kListGroup;
    } while (entry < count);
}
