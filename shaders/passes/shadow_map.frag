// Alpha-masked casters let light through their holes; the others need no fragment work.
#include "shared/slots.h"

#ifdef ALPHA_MASK
#include "shared/surface.h"
layout(std430, binding = kMaterialsSlot) readonly buffer Materials { SurfaceMaterial materials[]; };
layout(location = 1) uniform int material;
layout(binding = kMaterialTexturesUnit) uniform sampler2D baseColorTexture;
in vec2 maskUv;
in float vertexAlpha;
#endif

void main() {
#ifdef ALPHA_MASK
    SurfaceMaterial surface = materials[material];
    float alpha = surface.baseColor.a * vertexAlpha;
    if ((surface.flags.y & 1) != 0) {
        alpha *= texture(baseColorTexture, maskUv).a;
    }
    if (alpha < surface.emission.w) {
        discard;
    }
#endif
}
