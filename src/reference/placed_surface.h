// PlacedSurface: a primitive of triangles where it stands in the world, with its material.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace ribalta {

struct PlacedSurface {
    const Primitive* primitive = nullptr;       ///< the scene's, or `deformed`
    std::shared_ptr<const Primitive> deformed;  ///< in its shape, where the scene's is another
    const Material* material = nullptr;
    glm::dmat4 worldFromLocal{1.0};
    glm::dmat3 worldFromNormal{1.0};  ///< what turns normals; not their length
    bool mirrored = false;            ///< front faces run clockwise in the world
    double blendDepth = 0.0;  ///< of its box's centre along the view axis: blended far to near

    bool isBlended() const { return material->isSeeThrough(); }
    bool isMasked() const { return material->alphaMode == Material::AlphaMode::kMask; }
    /// Blended surfaces cast no shadow.
    bool castsShadow() const { return !isBlended(); }
    std::size_t triangles() const { return primitive->indices.size() / 3; }
    std::array<std::uint32_t, 3> corners(std::size_t triangle) const {
        return {primitive->indices[3 * triangle], primitive->indices[3 * triangle + 1],
                primitive->indices[3 * triangle + 2]};
    }
    glm::dvec3 position(std::uint32_t vertex) const {
        return {worldFromLocal * glm::dvec4(primitive->positions[vertex], 1.0)};
    }
    std::array<glm::dvec3, 3> cornerPositions(std::size_t triangle) const;
};

/// All triangles of the scene, which must outlive them; without points and lines. In the order in
/// which the scene's nodes stand. The camera decides blendDepth.
std::vector<PlacedSurface> placeSurfaces(const Scene& scene, const Camera& camera);

/// A vertex attribute blended by weights that add up to 1.
template <typename Attribute>
auto blended(const std::vector<Attribute>& values, const std::array<std::uint32_t, 3>& corners,
             const glm::dvec3& weights) {
    using Wide = glm::vec<Attribute::length(), double>;
    return weights.x * Wide(values[corners[0]]) + weights.y * Wide(values[corners[1]]) +
           weights.z * Wide(values[corners[2]]);
}

}  // namespace ribalta
