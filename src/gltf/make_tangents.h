// Tangents for normal-mapped primitives that have none.
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "scene/mesh.h"

namespace ribalta::gltf {

/// Fills primitive.tangents from positions, normals, indices and the texture coordinates `uv` that
/// the normal map is looked up with (one a vertex): Lengyel, "Foundations of Game Engine
/// Development" volume 2, section 7.5. A vertex's tangent is the sum over its triangles of the
/// direction in which u grows, weighted by the triangle's angle at the vertex, made perpendicular
/// to the normal; w is the sign with which the bitangent is cross(normal, tangent) * w. Not
/// MikkTSpace: vertices on a mirrored seam are not split.
void makeTangents(Primitive& primitive, const std::vector<glm::vec2>& uv);

}  // namespace ribalta::gltf
