// Alpha-masked casters let light through their holes; the others need no fragment work.
#include "shared/slots.h"

#ifdef ALPHA_MASK
#include "shared/surface.h"
layout(std140, binding = kMaterialSlot) uniform MaterialBlock { SurfaceMaterial material; };
layout(binding = kMaterialTexturesUnit) uniform sampler2D baseColorTexture;
in vec2 maskUv;
in float vertexAlpha;
#endif

void main() {
#ifdef ALPHA_MASK
    float alpha = material.baseColor.a * vertexAlpha;
    if ((material.flags.y & 1) != 0) {
        alpha *= texture(baseColorTexture, maskUv).a;
    }
    if (alpha < material.emission.w) {
        discard;
    }
#endif
}
