#include "gltf/make_tangents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace ribalta::gltf {
namespace {

using Corners = std::array<glm::dvec3, 3>;

// The angle of a triangle at one corner, radians; 0 where the triangle has no area.
double angleAt(const Corners& corners, std::size_t k) {
    const glm::dvec3 a = corners[(k + 1) % 3] - corners[k];
    const glm::dvec3 b = corners[(k + 2) % 3] - corners[k];
    const double size = glm::length(a) * glm::length(b);
    return size > 0.0 ? std::acos(std::clamp(glm::dot(a, b) / size, -1.0, 1.0)) : 0.0;
}

glm::dvec3 unitOrZero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? v / length : glm::dvec3(0.0);
}

// Any direction across the normal, for vertices whose texture coordinates say nothing.
glm::dvec3 anyAcross(const glm::dvec3& normal) {
    const glm::dvec3 axis =
        std::abs(normal.x) < 0.5 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    return glm::normalize(axis - normal * glm::dot(normal, axis));
}

}  // namespace

void makeTangents(Primitive& primitive, const std::vector<glm::vec2>& uv) {
    const std::size_t count = primitive.positions.size();
    std::vector<glm::dvec3> alongU(count, glm::dvec3(0.0));
    std::vector<glm::dvec3> alongV(count, glm::dvec3(0.0));
    for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
        const std::uint32_t* index = &primitive.indices[i];
        const Corners p = {glm::dvec3(primitive.positions[index[0]]),
                           glm::dvec3(primitive.positions[index[1]]),
                           glm::dvec3(primitive.positions[index[2]])};
        const glm::dvec2 uv1 = glm::dvec2(uv[index[1]]) - glm::dvec2(uv[index[0]]);
        const glm::dvec2 uv2 = glm::dvec2(uv[index[2]]) - glm::dvec2(uv[index[0]]);
        const double area = uv1.x * uv2.y - uv2.x * uv1.y;
        const double sign = area < 0.0 ? -1.0 : 1.0;
        if (area == 0.0) {
            continue;
        }
        const glm::dvec3 edge1 = p[1] - p[0];
        const glm::dvec3 edge2 = p[2] - p[0];
        const glm::dvec3 u = unitOrZero(sign * (edge1 * uv2.y - edge2 * uv1.y));
        const glm::dvec3 v = unitOrZero(sign * (edge2 * uv1.x - edge1 * uv2.x));
        for (std::size_t k = 0; k < 3; ++k) {
            const double weight = angleAt(p, k);
            alongU[index[k]] += weight * u;
            alongV[index[k]] += weight * v;
        }
    }
    primitive.tangents.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 normal(primitive.normals[i]);
        glm::dvec3 tangent = unitOrZero(alongU[i] - normal * glm::dot(normal, alongU[i]));
        if (tangent == glm::dvec3(0.0)) {
            tangent = anyAcross(normal);
        }
        const double side = glm::dot(glm::cross(normal, tangent), alongV[i]);
        primitive.tangents[i] = glm::vec4(glm::vec3(tangent), side < 0.0 ? -1.0F : 1.0F);
    }
}

}  // namespace ribalta::gltf
