// Beams, method `adaptive`, fifth step: every pixel between the finer lattice's points, but for those of
// the listed quads that are no points themselves. An invocation is a cell.
#include "shared/slots.h"
#include "shared/beams.h"
#include "lib/beam_lattice.glsl"

layout(local_size_x = kBeamGroup) in;
layout(std140, binding = kBeamSettingsSlot) uniform SettingsBlock { BeamSettings settings; };
layout(std430, binding = kTilesSlot) readonly buffer Tiles { BeamSquare tiles[]; };
layout(binding = kBeamFineUnit) uniform sampler2D fineMap;
layout(binding = kBeamQuadsUnit) uniform sampler2D quadsMap;
layout(rgba32f, binding = kColorUnit) uniform image2D colorMap;
#ifdef BEAMS_OUTPUT
layout(rgba32f, binding = kBeamsOutputUnit) uniform writeonly image2D beamsMap;
#endif

void addTo(ivec2 pixel, vec3 radiance) {
    vec4 sum = vec4(radiance, 0.0);
    imageStore(colorMap, pixel, imageLoad(colorMap, pixel) + sum);
#ifdef BEAMS_OUTPUT
    imageStore(beamsMap, pixel, sum);
#endif
}

void fillQuad(ivec2 quad) {
    vec3 p00 = texelFetch(fineMap, quad, 0).rgb;
    vec3 p10 = texelFetch(fineMap, quad + ivec2(1, 0), 0).rgb;
    vec3 p01 = texelFetch(fineMap, quad + ivec2(0, 1), 0).rgb;
    vec3 p11 = texelFetch(fineMap, quad + ivec2(1, 1), 0).rgb;
    ivec2 pixel = quad * kFineStep;
    addTo(pixel, p00);
    if (texelFetch(quadsMap, quad, 0).r < 0.5) {
        addTo(pixel + ivec2(1, 0), 0.5 * (p00 + p10));
        addTo(pixel + ivec2(0, 1), 0.5 * (p00 + p01));
        addTo(pixel + ivec2(1, 1), 0.25 * (p00 + p10 + p01 + p11));
    }
}

void fillCell(BeamSquare tile, int place) {
    ivec2 cell = tile.place.xy * kTileCellsAcross +
                 ivec2(place % kTileCellsAcross, place / kTileCellsAcross);
    for (int i = 0; i < kCellQuads; ++i) {
        fillQuad(cell * kCellQuadsAcross + ivec2(i % kCellQuadsAcross, i / kCellQuadsAcross));
    }
}

void main() {
    int cell = int(gl_GlobalInvocationID.x);
    int count = settings.lattice.z * kTileCells;
    do {
        if (cell < count) {
            fillCell(tiles[cell / kTileCells], cell % kTileCells);
        }
        cell += int(gl_NumWorkGroups.x) * kBeamGroup;
    } while (cell < count);
}
