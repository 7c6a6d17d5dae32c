#include "reference/placed_surface.h"

#include <algorithm>
#include <utility>

namespace ribalta {
namespace {

// The adjugate turns normals as the inverse transpose does, and stands a flattened node.
glm::dmat3 normalMatrix(const glm::dmat3& linear, bool mirrored) {
    glm::dmat3 normals(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                       glm::cross(linear[0], linear[1]));
    const double size =
        std::max({glm::length(normals[0]), glm::length(normals[1]), glm::length(normals[2])});
    return normals * (size > 0.0 ? (mirrored ? -1.0 : 1.0) / size : 0.0);
}

// The primitive with the vertices that it has in the deformer's shape.
std::shared_ptr<const Primitive> deformedPrimitive(const Primitive& primitive,
                                                   const Deformer& deformer) {
    DeformedVertices vertices = deformVertices(primitive, deformer);
    auto result = std::make_shared<Primitive>();
    result->topology = primitive.topology;
    result->positions = std::move(vertices.positions);
    result->normals = std::move(vertices.normals);
    result->tangents = std::move(vertices.tangents);
    result->uv0 = primitive.uv0;
    result->uv1 = primitive.uv1;
    result->colors = primitive.colors;
    result->indices = primitive.indices;
    result->material = primitive.material;
    result->bounds = deformedBounds(primitive, deformer);
    return result;
}

}  // namespace

std::array<glm::dvec3, 3> PlacedSurface::cornerPositions(std::size_t triangle) const {
    const std::array<std::uint32_t, 3> vertices = corners(triangle);
    return {position(vertices[0]), position(vertices[1]), position(vertices[2])};
}

std::vector<PlacedSurface> placeSurfaces(const Scene& scene, const Camera& camera) {
    static const Material defaultMaterial;
    std::vector<PlacedSurface> surfaces;
    for (const Node& node : scene.nodes) {
        if (!node.isDrawn()) {
            continue;
        }
        for (const Primitive& primitive : scene.meshes[std::size_t(node.mesh)].primitives) {
            if (primitive.topology != Topology::kTriangles || primitive.indices.size() < 3) {
                continue;
            }
            PlacedSurface surface;
            surface.primitive = &primitive;
            surface.material = primitive.material < 0
                                   ? &defaultMaterial
                                   : &scene.materials[std::size_t(primitive.material)];
            surface.worldFromLocal = node.worldFromLocal;
            if (node.deformer >= 0) {
                surface.deformed =
                    deformedPrimitive(primitive, scene.deformers[std::size_t(node.deformer)]);
                surface.primitive = surface.deformed.get();
            }
            const glm::dmat3 linear(node.worldFromLocal);
            surface.mirrored = glm::determinant(linear) < 0.0;
            surface.worldFromNormal = normalMatrix(linear, surface.mirrored);
            const Bounds bounds = transformed(node.worldFromLocal, surface.primitive->bounds);
            surface.blendDepth =
                bounds.isEmpty()
                    ? 0.0
                    : glm::dot(camera.frame.forward(), bounds.centre() - camera.frame.position);
            surfaces.push_back(std::move(surface));
        }
    }
    return surfaces;
}

}  // namespace ribalta
