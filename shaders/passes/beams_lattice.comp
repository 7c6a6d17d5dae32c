// Beams, method `adaptive`, first step: the light at the lattice's points, and how far along the ray
// the last beam reaches. An invocation is a point.
#include "passes/beams_sheets.glsl"

layout(local_size_x = kBeamGroup) in;
layout(std430, binding = kTilesSlot) readonly buffer Tiles { BeamSquare tiles[]; };
layout(rgba32f, binding = kBeamLatticeUnit) uniform writeonly image2D latticeMap;

void drawPoint(BeamSquare tile, int place) {
    ivec2 point = tile.place.xy * kTileCellsAcross +
                  ivec2(place % kTileCellsAcross, place / kTileCellsAcross);
    ivec2 pixel = min(point * kLatticeStep, ivec2(view.picture.xy) - 1);
    float beamEnd = 0.0;
    vec3 sum = beamsRadiance(pixelRay(pixel), tile.place.zw, beamEnd);
    imageStore(latticeMap, point, vec4(sum, beamEnd));
}

void main() {
    int point = int(gl_GlobalInvocationID.x);
    int count = settings.lattice.z * kTileCells;
    do {
        if (point < count) {
            drawPoint(tiles[point / kTileCells], point % kTileCells);
        }
        point += int(gl_NumWorkGroups.x) * kBeamGroup;
    } while (point < count);
}
