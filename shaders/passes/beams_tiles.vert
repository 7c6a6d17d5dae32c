// A square for every tile of the picture that some beam covers.
#include "shared/slots.h"
#include "shared/view.h"
#include "shared/beams.h"

layout(std140, binding = kViewSlot) uniform ViewBlock { View view; };
layout(std430, binding = kTilesSlot) readonly buffer Tiles { BeamSquare tiles[]; };
flat out ivec2 lampRange;

void main() {
    ivec4 tile = tiles[gl_InstanceID].place;
    lampRange = tile.zw;
    vec2 corner = vec2(tile.x + (gl_VertexID & 1), tile.y + (gl_VertexID >> 1)) * float(kTileSide);
    gl_Position = vec4(2.0 * corner * view.picture.zw - 1.0, 0.5, 1.0);
}
