// Deformation: morphs, then skins a primitive's vertices into the buffers that they are drawn from.
// The same steps as src/scene/deformer.cpp.
#include "shared/slots.h"
#include "shared/deform.h"
#include "lib/deform.glsl"

layout(local_size_x = kDeformGroup) in;
layout(std140, binding = kDeformJobSlot) uniform JobBlock { DeformJob job; };
layout(std430, binding = kDeformRestSlot) readonly buffer Rest { float rest[]; };
layout(std430, binding = kDeformInfluencesSlot) readonly buffer Influences { uvec2 influences[]; };
layout(std430, binding = kDeformJointsSlot) readonly buffer Joints { mat4 localFromMesh[]; };
layout(std430, binding = kDeformActiveSlot) readonly buffer Active { ActiveTarget active_targets[]; };
layout(std430, binding = kDeformTargetsSlot) readonly buffer Targets { float displacements[]; };
layout(std430, binding = kDeformPositionsSlot) writeonly buffer Positions { float positions[]; };
layout(std430, binding = kDeformAttributesSlot) buffer Attributes { float attributes[]; };

vec3 restVector(int vertex, int part) {
    int at = vertex * kRestFloats + part;
    return vec3(rest[at], rest[at + 1], rest[at + 2]);
}

// `part`: 0 positions, 1 normals, 2 tangents.
vec3 morphed(int vertex, int part) {
    vec3 sum = restVector(vertex, 3 * part);
    for (int t = 0; t < job.counts.z; ++t) {
        ivec4 starts = active_targets[t].starts;
        int start = starts[part];
        if (start >= 0) {
            int at = start + 3 * vertex;
            sum = addTarget(sum, vec3(displacements[at], displacements[at + 1], displacements[at + 2]),
                            intBitsToFloat(starts.w));
        }
    }
    return sum;
}

mat4 blend(int vertex) {
    if (job.counts.y == 0) {
        return mat4(1.0);
    }
    mat4 sum = mat4(0.0);
    for (int i = 0; i < job.counts.y; ++i) {
        uvec2 influence = influences[vertex * job.counts.y + i];
        float weight = uintBitsToFloat(influence.y);
        if (weight > 0.0) {
            sum = addJoint(sum, localFromMesh[min(int(influence.x), job.limits.x - 1)], weight);
        }
    }
    return sum;
}

void main() {
    int vertex = int(gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x +
                     gl_GlobalInvocationID.x);
    if (vertex >= job.counts.x) {
        return;
    }
    mat4 matrix = blend(vertex);
    vec3 position = deformedPosition(matrix, morphed(vertex, 0));
    positions[3 * vertex] = position.x;
    positions[3 * vertex + 1] = position.y;
    positions[3 * vertex + 2] = position.z;
    int at = kAttributeFloats * vertex;
    if ((job.counts.w & kDeformNormals) != 0) {
        vec3 normal = deformedNormal(matrix, morphed(vertex, 1));
        if ((job.counts.w & kDeformFlat) != 0) {
            int first = vertex / 3 * 3;
            vec3 a = deformedPosition(blend(first), morphed(first, 0));
            vec3 b = deformedPosition(blend(first + 1), morphed(first + 1, 0));
            vec3 c = deformedPosition(blend(first + 2), morphed(first + 2, 0));
            normal = faceNormal(a, b, c, deformedSide(matrix), normal);
        }
        attributes[at] = normal.x;
        attributes[at + 1] = normal.y;
        attributes[at + 2] = normal.z;
    }
    if ((job.counts.w & kDeformTangents) != 0) {
        vec3 tangent = deformedTangent(matrix, morphed(vertex, 2));
        attributes[at + 3] = tangent.x;
        attributes[at + 4] = tangent.y;
        attributes[at + 5] = tangent.z;
        attributes[at + 6] = rest[vertex * kRestFloats + 9] * deformedSide(matrix);
    }
}
