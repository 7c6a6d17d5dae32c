// Depth of the casters as a lamp sees them.
#include "shared/slots.h"

layout(location = kPositionAttribute) in vec3 position;
layout(location = kInstanceAttribute) in mat4 clipFromLocal;

#ifdef ALPHA_MASK
#include "shared/surface.h"
layout(location = kUv0Attribute) in vec2 uv0;
layout(location = kUv1Attribute) in vec2 uv1;
layout(location = kColorAttribute) in vec4 color;
layout(std140, binding = kMaterialSlot) uniform MaterialBlock { SurfaceMaterial material; };
out vec2 maskUv;
out float vertexAlpha;
#endif

void main() {
    gl_Position = clipFromLocal * vec4(position, 1.0);
#ifdef ALPHA_MASK
    vec3 uv = vec3((material.flags.z & 1) != 0 ? uv1 : uv0, 1.0);
    maskUv = vec2(dot(material.uvRows[0].xyz, uv), dot(material.uvRows[1].xyz, uv));
    vertexAlpha = color.a;
#endif
}
