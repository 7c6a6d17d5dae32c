#include "render/occluders.h"

#include <algorithm>
#include <cmath>

#include <glm/gtx/exterior_product.hpp>

#include "render/lamp_reach.h"

namespace ribalta {
namespace {

constexpr std::size_t kMaxOccluders = 8;
constexpr double kLeastShare = 0.01;
// Walls and floors have few triangles and keep their shape; other meshes are not searched.
constexpr std::size_t kMaxTriangles = 64;
// Pixels by which an occluder has to reach over a beam, for the rounding of corners.
constexpr double kOverlapPixels = 0.5;

using Polygon = std::vector<glm::dvec2>;

double area(const Polygon& polygon) {
    double twice = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
    }
    return 0.5 * twice;
}

// The part of a convex polygon where distance(point) >= 0; distance is linear.
template <typename Point, typename Distance>
std::vector<Point> cut(const std::vector<Point>& polygon, const Distance& distance) {
    std::vector<Point> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point& a = polygon[i];
        const Point& b = polygon[(i + 1) % polygon.size()];
        const double from = distance(a);
        const double to = distance(b);
        if (from >= 0.0) {
            kept.push_back(a);
        }
        if ((from < 0.0) != (to < 0.0)) {
            kept.push_back(a + (b - a) * (from / (from - to)));
        }
    }
    return kept;
}

Polygon cutToPicture(Polygon polygon, int width, int height) {
    polygon = cut(polygon, [](const glm::dvec2& p) { return p.x; });
    polygon = cut(polygon, [](const glm::dvec2& p) { return p.y; });
    polygon = cut(polygon, [&](const glm::dvec2& p) { return width - p.x; });
    return cut(polygon, [&](const glm::dvec2& p) { return height - p.y; });
}

using Face = std::vector<glm::dvec3>;

// The convex quad that two neighbouring triangles make in one plane; empty where they do not.
Face joined(const Face& triangle, const Face& next) {
    const glm::dvec3 normal = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    const double size = glm::length(normal);
    for (std::size_t n = 0; n < 3; ++n) {
        for (std::size_t i = 0; i < 3; ++i) {
            // The corner that the first triangle lacks goes between the two that they share.
            if (triangle[i] != next[(n + 2) % 3] || triangle[(i + 1) % 3] != next[(n + 1) % 3]) {
                continue;
            }
            Face quad = triangle;
            quad.insert(quad.begin() + std::ptrdiff_t(i) + 1, next[n]);
            const double off = std::abs(glm::dot(normal, next[n] - triangle[0]));
            bool convex = size > 0.0 && off <= 1e-9 * size * std::sqrt(size);
            for (std::size_t k = 0; k < 4; ++k) {
                const glm::dvec3 along = quad[(k + 1) % 4] - quad[k];
                const glm::dvec3 on = quad[(k + 2) % 4] - quad[(k + 1) % 4];
                convex = convex && glm::dot(glm::cross(along, on), normal) > 0.0;
            }
            return convex ? quad : Face();
        }
    }
    return {};
}

// Convex faces in world space: quads where two triangles in a row make one, and triangles.
std::vector<Face> facesOf(const Primitive& primitive, const glm::dmat4& worldFromLocal) {
    std::vector<Face> faces;
    for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
        Face triangle;
        for (std::size_t c = 0; c < 3; ++c) {
            const glm::dvec4 local(glm::dvec3(primitive.positions[primitive.indices[i + c]]), 1.0);
            triangle.emplace_back(worldFromLocal * local);
        }
        const Face quad =
            !faces.empty() && faces.back().size() == 3 ? joined(faces.back(), triangle) : Face();
        if (quad.empty()) {
            faces.push_back(std::move(triangle));
        } else {
            faces.back() = quad;
        }
    }
    return faces;
}

bool mayHide(const Scene& scene, const DrawItem& item) {
    const Primitive& primitive = primitiveOf(scene, item);
    return deformerOf(scene, item) < 0 && primitive.topology == Topology::kTriangles &&
           primitive.indices.size() <= 3 * kMaxTriangles &&
           materialOf(scene, item).alphaMode == Material::AlphaMode::kOpaque &&
           !materialOf(scene, item).isSeeThrough();
}

// The area of the picture, in pixels, that nothing within the bounds covers more of.
double mostShown(const Bounds& bounds, const glm::dmat4& clip, int width, int height) {
    const glm::dvec2 size(width, height);
    glm::dvec2 low = size;
    glm::dvec2 high(0.0);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec4 place = clip * glm::dvec4(bounds.corner(corner), 1.0);
        if (!(place.w > 0.0)) {
            return size.x * size.y;
        }
        const glm::dvec2 pixel = (glm::dvec2(place) / place.w + 1.0) * 0.5 * size;
        low = glm::min(low, pixel);
        high = glm::max(high, pixel);
    }
    const glm::dvec2 shown = glm::min(high, size) - glm::max(low, glm::dvec2(0.0));
    return std::max(shown.x, 0.0) * std::max(shown.y, 0.0);
}

// The face as the camera sees it; without an outline where it shows its unseen side.
Occluder seen(Face face, double frontSide, bool doubleSided, const Camera& camera, int width,
              int height) {
    const glm::dvec3 turn = glm::cross(face[1] - face[0], face[2] - face[0]);
    if (!(glm::length(turn) > 0.0)) {
        return {};
    }
    const glm::dvec3 axis = camera.frame.forward();
    const glm::dvec3 front = frontSide * glm::normalize(turn);
    const double side =
        glm::dot(front, camera.isOrthographic() ? -axis : camera.frame.position - face[0]);
    if (side == 0.0 || (side < 0.0 && !doubleSided)) {
        return {};
    }
    Occluder occluder{face[0], side > 0.0 ? front : -front, {}};
    // What lies before the near plane or beyond the far one is not drawn.
    const auto depth = [&](const glm::dvec3& p) {
        return glm::dot(axis, p - camera.frame.position);
    };
    const double near = camera.nearMetres * (1.0 + 1e-6);
    face = cut(face, [&](const glm::dvec3& p) { return depth(p) - near; });
    if (std::isfinite(camera.farMetres)) {
        const double far = camera.farMetres * (1.0 - 1e-6);
        face = cut(face, [&](const glm::dvec3& p) { return far - depth(p); });
    }
    const glm::dmat4 clip = clipFromWorld(camera, width, height);
    for (const glm::dvec3& corner : face) {
        const glm::dvec4 place = clip * glm::dvec4(corner, 1.0);
        occluder.outline.emplace_back((place.x / place.w + 1.0) * 0.5 * width,
                                      (place.y / place.w + 1.0) * 0.5 * height);
    }
    if (area(occluder.outline) < 0.0) {
        std::reverse(occluder.outline.begin(), occluder.outline.end());
    }
    return occluder;
}

}  // namespace

std::vector<Occluder> listOccluders(const Scene& scene, const std::vector<DrawItem>& draws,
                                    const std::vector<bool>& visible, const Camera& camera,
                                    int width, int height) {
    std::vector<std::pair<double, Occluder>> found;
    const double least = kLeastShare * width * height;
    const glm::dmat4 clip = clipFromWorld(camera, width, height);
    for (std::size_t i = 0; i < draws.size(); ++i) {
        // What is rounded may not lose a face of just that size.
        if (!visible[i] || !mayHide(scene, draws[i]) ||
            mostShown(draws[i].worldBounds, clip, width, height) < 0.999 * least) {
            continue;
        }
        const glm::dmat4& place = scene.nodes[std::size_t(draws[i].node)].worldFromLocal;
        const double frontSide = glm::determinant(glm::dmat3(place)) < 0.0 ? -1.0 : 1.0;
        const bool doubleSided = materialOf(scene, draws[i]).doubleSided;
        for (Face& face : facesOf(primitiveOf(scene, draws[i]), place)) {
            Occluder occluder =
                seen(std::move(face), frontSide, doubleSided, camera, width, height);
            const double shown = area(cutToPicture(occluder.outline, width, height));
            if (shown >= least) {
                found.emplace_back(shown, std::move(occluder));
            }
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<Occluder> largest;
    for (std::size_t i = 0; i < found.size() && i < kMaxOccluders; ++i) {
        largest.push_back(std::move(found[i].second));
    }
    return largest;
}

bool hides(const Occluder& occluder, const SpotLight& lamp, const std::vector<glm::dvec2>& outline,
           int width, int height) {
    // Behind its plane, every corner of the beam: a tenth of a millimetre, and as much for each
    // metre, are left for rounding.
    for (const glm::dvec4& corner : beamCorners(lamp)) {
        const glm::dvec3 from = glm::dvec3(corner) - corner.w * occluder.point;
        const double side = glm::dot(occluder.towardsCamera, from);
        if (!(side <= -1e-4 * corner.w * (1.0 + glm::length(from)))) {
            return false;
        }
    }
    // And within its outline, all of the beam that is in the picture.
    const std::vector<glm::dvec2> shown = cutToPicture(outline, width, height);
    const std::vector<glm::dvec2>& edge = occluder.outline;
    for (std::size_t i = 0; i < edge.size(); ++i) {
        const glm::dvec2 along = edge[(i + 1) % edge.size()] - edge[i];
        for (const glm::dvec2& point : shown) {
            if (cross(along, point - edge[i]) < kOverlapPixels * glm::length(along)) {
                return false;
            }
        }
    }
    return !shown.empty();
}

bool isBeyondFarPlane(const SpotLight& lamp, const Camera& camera) {
    if (!std::isfinite(camera.farMetres)) {
        return false;
    }
    const glm::dvec3 axis = camera.frame.forward();
    for (const glm::dvec4& corner : beamCorners(lamp)) {
        const double depth = glm::dot(axis, glm::dvec3(corner) - corner.w * camera.frame.position);
        if (!(depth > corner.w * camera.farMetres * (1.0 + 1e-6)) &&
            !(corner.w == 0.0 && depth >= 0.0)) {
            return false;
        }
    }
    return true;
}

}  // namespace ribalta
