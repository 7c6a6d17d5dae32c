// The least and the greatest depth over blocks of shadow maps. Level 0: of blocks of 4 x 4 texels;
// level n: of blocks of 4 << n, each together with its next neighbours to the right and above, so that
// a box no larger than a block lies within the one texel that its lowest corner falls into.
#include "shared/slots.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = kPyramidLayersSlot) readonly buffer Layers { int layers[]; };
layout(rg32f, binding = kPyramidUnit) uniform writeonly image2DArray target;
#ifdef FROM_MAPS
layout(binding = kShadowMapsUnit) uniform sampler2DArray shadowMaps;
#else
layout(location = 0) uniform int sourceLevel;
layout(binding = kShadowPyramidUnit) uniform sampler2DArray pyramid;
#endif

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    int layer = layers[gl_GlobalInvocationID.z];
    if (any(greaterThanEqual(at, imageSize(target).xy))) {
        return;
    }
    vec2 depths = vec2(1.0e30, -1.0e30);
#ifdef FROM_MAPS
    float side = float(textureSize(shadowMaps, 0).x);
    for (int i = 0; i < 4; ++i) {
        vec2 corner = vec2(4 * at + 2 * ivec2(i & 1, i >> 1) + 1);
        vec4 four = textureGather(shadowMaps, vec3(corner / side, float(layer)));
        depths.x = min(depths.x, min(min(four.x, four.y), min(four.z, four.w)));
        depths.y = max(depths.y, max(max(four.x, four.y), max(four.z, four.w)));
    }
#else
    // Level 0 has blocks without their neighbours.
    int last = textureSize(pyramid, sourceLevel).x - 1;
    int step = sourceLevel == 0 ? 1 : 2;
    for (int y = 0; y < 4; y += step) {
        for (int x = 0; x < 4; x += step) {
            vec2 block = texelFetch(pyramid, ivec3(min(2 * at + ivec2(x, y), last), layer), sourceLevel).rg;
            depths.x = min(depths.x, block.x);
            depths.y = max(depths.y, block.y);
        }
    }
#endif
    imageStore(target, ivec3(at, layer), vec4(depths, 0.0, 0.0));
}
