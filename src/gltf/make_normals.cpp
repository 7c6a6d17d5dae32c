#include "gltf/make_normals.h"

#include <cstddef>
#include <numeric>
#include <vector>

namespace ribalta::gltf {
namespace {

template <typename T>
void unshare(std::vector<T>& values, const std::vector<std::uint32_t>& indices,
             std::size_t each = 1) {
    if (values.empty()) {
        return;
    }
    std::vector<T> own;
    own.reserve(indices.size() * each);
    for (const std::uint32_t index : indices) {
        for (std::size_t i = 0; i < each; ++i) {
            own.push_back(values[index * each + i]);
        }
    }
    values = std::move(own);
}

}  // namespace

void makeFlatNormals(Primitive& primitive) {
    unshare(primitive.positions, primitive.indices);
    unshare(primitive.uv0, primitive.indices);
    unshare(primitive.uv1, primitive.indices);
    unshare(primitive.colors, primitive.indices);
    unshare(primitive.influences, primitive.indices, std::size_t(primitive.influencesPerVertex));
    for (MorphTarget& target : primitive.targets) {
        unshare(target.positions, primitive.indices);
        target.normals.clear();
        target.tangents.clear();
    }
    primitive.flatNormals = true;
    // Tangents without normals have no meaning; glTF asks to ignore them.
    primitive.tangents.clear();
    std::iota(primitive.indices.begin(), primitive.indices.end(), 0U);
    primitive.normals.assign(primitive.positions.size(), glm::vec3(0.0F, 1.0F, 0.0F));
    for (std::size_t i = 0; i + 2 < primitive.positions.size(); i += 3) {
        const glm::dvec3 a(primitive.positions[i]);
        const glm::dvec3 b(primitive.positions[i + 1]);
        const glm::dvec3 c(primitive.positions[i + 2]);
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        const double length = glm::length(normal);
        if (length > 0.0) {
            const glm::vec3 unit(normal / length);
            primitive.normals[i] = primitive.normals[i + 1] = primitive.normals[i + 2] = unit;
        }
    }
}

}  // namespace ribalta::gltf
