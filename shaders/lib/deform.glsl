// Deformation: where morph targets and joints take a vertex (glTF 2.0, sections 3.7.2.2 and
// 3.7.3.3). Morphed first, then skinned. Where the numbers lie is the caller's business.

/// A sum of displacements, by one more target.
vec3 addTarget(vec3 sum, vec3 displacement, float weight) {
    return sum + weight * displacement;
}

/// A blend of matrices, by one more joint. Weights add up to 1.
mat4 addJoint(mat4 sum, mat4 localFromMesh, float weight) {
    return sum + weight * localFromMesh;
}

vec3 deformedPosition(mat4 localFromMesh, vec3 position) {
    return vec3(localFromMesh * vec4(position, 1.0));
}

/// -1 where the matrix turns the inside out, else 1.
float deformedSide(mat4 localFromMesh) {
    return dot(vec3(localFromMesh[0]), cross(vec3(localFromMesh[1]), vec3(localFromMesh[2]))) < 0.0 ? -1.0 : 1.0;
}

/// `vector` at unit length; `otherwise` where it has none.
vec3 unitOr(vec3 vector, vec3 otherwise) {
    float largest = max(max(abs(vector.x), abs(vector.y)), abs(vector.z));
    if (!(largest > 0.0)) {
        return otherwise;
    }
    vec3 scaled = vector / largest;  // so that neither tiny nor huge ones leave single precision
    return scaled / length(scaled);
}

/// A normal, at unit length. The cofactors turn normals as the inverse transpose does, which is the
/// same but for the determinant's size, and stand a flattened joint; with the determinant's sign
/// what was outside stays outside.
vec3 deformedNormal(mat4 localFromMesh, vec3 normal) {
    vec3 x = vec3(localFromMesh[0]);
    vec3 y = vec3(localFromMesh[1]);
    vec3 z = vec3(localFromMesh[2]);
    float size = max(max(length(x), length(y)), length(z));
    if (!(size > 0.0)) {
        return normal;
    }
    x = x / size;
    y = y / size;
    z = z / size;
    vec3 turned = normal.x * cross(y, z) + normal.y * cross(z, x) + normal.z * cross(x, y);
    return unitOr(deformedSide(localFromMesh) * turned, normal);
}

/// A tangent, at unit length: it lies in the surface and moves with it.
vec3 deformedTangent(mat4 localFromMesh, vec3 tangent) {
    return unitOr(tangent.x * vec3(localFromMesh[0]) + tangent.y * vec3(localFromMesh[1]) +
                      tangent.z * vec3(localFromMesh[2]),
                  tangent);
}

/// The normal of a deformed triangle; `otherwise` where it has no area.
vec3 faceNormal(vec3 a, vec3 b, vec3 c, float side, vec3 otherwise) {
    return unitOr(side * cross(b - a, c - a), otherwise);
}
