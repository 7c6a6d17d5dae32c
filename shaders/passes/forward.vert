// Surfaces: vertices into view space.
#include "shared/slots.h"
#include "shared/view.h"
#include "shared/surface.h"

layout(location = kPositionAttribute) in vec3 position;
layout(location = kNormalAttribute) in vec3 normal;
layout(location = kTangentAttribute) in vec4 tangent;
layout(location = kUv0Attribute) in vec2 uv0;
layout(location = kUv1Attribute) in vec2 uv1;
layout(location = kColorAttribute) in vec4 color;
layout(location = kInstanceAttribute) in mat4 viewFromLocal;
layout(location = kInstanceAttribute + 4) in mat3x4 viewFromNormal;

layout(std140, binding = kViewSlot) uniform ViewBlock { View view; };

out vec3 viewPosition;
out vec3 viewNormal;
out vec4 vertexColor;
#ifdef TEXTURES
out vec4 viewTangent;
out vec2 firstUv;
out vec2 secondUv;
#endif

void main() {
    vec4 place = viewFromLocal * vec4(position, 1.0);
    viewPosition = place.xyz;
    viewNormal = mat3(viewFromNormal) * normal;
    vertexColor = color;
#ifdef TEXTURES
    viewTangent = vec4(mat3(viewFromLocal) * tangent.xyz, tangent.w);
    firstUv = uv0;
    secondUv = uv1;
#endif
    gl_Position = view.clipFromView * place;
    gl_PointSize = 2.0;
}
