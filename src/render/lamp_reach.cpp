#include "render/lamp_reach.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/gtx/exterior_product.hpp>

namespace ribalta {
namespace {

// Sides of the pyramid that stands in for the cone; it encloses the cone.
constexpr int kSides = 16;

// How far an unlimited beam is followed where a point at infinity has no place in the picture.
constexpr double kFarMetres = 1e5;

// Andrew's monotone chain.
std::vector<glm::dvec2> convexHull(std::vector<glm::dvec2> points) {
    std::sort(points.begin(), points.end(), [](const glm::dvec2& a, const glm::dvec2& b) {
        return a.x != b.x ? a.x < b.x : a.y < b.y;
    });
    if (points.size() < 3) {
        return points;
    }
    std::vector<glm::dvec2> hull;
    for (int half = 0; half < 2; ++half) {
        const std::size_t start = hull.size();
        for (const glm::dvec2& point : points) {
            while (hull.size() >= start + 2 &&
                   cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0.0) {
                hull.pop_back();
            }
            hull.push_back(point);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

// A corner of the beam in homogeneous world coordinates: w = 1 is a point, w = 0 a direction.
using Corner = glm::dvec4;

// The ring at the beam's end: points at the lamp's range, or the directions of an unlimited beam.
std::vector<Corner> endRing(const SpotLight& lamp, bool directions) {
    const double tangent = std::tan(drawnConeAngle(lamp));
    const bool pyramid = lamp.beamShape == BeamShape::kPyramid;
    const int sides = pyramid ? 4 : kSides;
    const double radius = tangent / std::cos(std::numbers::pi / sides);
    const double depth = std::isfinite(lamp.rangeMetres) ? lamp.rangeMetres : kFarMetres;
    std::vector<Corner> ring;
    for (int i = 0; i < sides; ++i) {
        // Half a step on: a square's corners lie on the diagonals.
        const double angle = 2.0 * std::numbers::pi * (i + 0.5) / sides;
        const glm::dvec3 along = lamp.frame.forward() +
                                 radius * std::cos(angle) * lamp.frame.right() +
                                 radius * std::sin(angle) * lamp.frame.up();
        ring.push_back(directions ? Corner(along, 0.0)
                                  : Corner(lamp.frame.position + depth * along, 1.0));
    }
    return ring;
}

}  // namespace

bool isDark(const SpotLight& lamp) {
    return !lamp.shown || !(lamp.intensityCandela > 0.0) ||
           !(std::max({lamp.color.x, lamp.color.y, lamp.color.z}) > 0.0F) ||
           !(lamp.rangeMetres > 0.0);
}

double drawnConeAngle(const SpotLight& lamp) {
    return std::clamp(lamp.outerConeAngle, kMinConeAngle, kMaxConeAngle);
}

glm::dmat4 lampFromWorld(const SpotLight& lamp) {
    const glm::dmat3 rotation =
        glm::transpose(glm::dmat3(lamp.frame.right(), lamp.frame.up(), lamp.frame.forward()));
    glm::dmat4 matrix(rotation);
    matrix[3] = glm::dvec4(-(rotation * lamp.frame.position), 1.0);
    return matrix;
}

std::vector<glm::dvec4> beamCorners(const SpotLight& lamp) {
    std::vector<Corner> corners = endRing(lamp, !std::isfinite(lamp.rangeMetres));
    corners.insert(corners.begin(), Corner(lamp.frame.position, 1.0));
    return corners;
}

bool beamTouches(const SpotLight& lamp, const Bounds& worldBounds) {
    if (worldBounds.isEmpty()) {
        return false;
    }
    const glm::dvec3 centre = worldBounds.centre() - lamp.frame.position;
    const glm::dvec3 half = worldBounds.halfSize();
    // The box against the planes of the pyramid around the beam, each through the apex.
    const double angle = drawnConeAngle(lamp);
    const glm::dvec3 axis = lamp.frame.forward();
    const int sides = lamp.beamShape == BeamShape::kPyramid ? 4 : kSides;
    for (int i = 0; i < sides; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / sides;
        const glm::dvec3 outwards =
            std::cos(turn) * lamp.frame.right() + std::sin(turn) * lamp.frame.up();
        const glm::dvec3 normal = std::cos(angle) * outwards - std::sin(angle) * axis;
        if (glm::dot(normal, centre) > glm::dot(glm::abs(normal), half)) {
            return false;
        }
    }
    // Behind the lamp, or beyond its range.
    if (glm::dot(axis, centre) < -glm::dot(glm::abs(axis), half)) {
        return false;
    }
    const glm::dvec3 nearest = glm::max(glm::abs(centre) - half, glm::dvec3(0.0));
    return glm::length(nearest) <= lamp.rangeMetres;
}

bool viewTouches(const glm::dmat4& clipFromWorld, const Bounds& worldBounds) {
    if (worldBounds.isEmpty()) {
        return false;
    }
    // Outside where all corners are beyond one of the clip planes.
    int outside[6] = {};
    for (int i = 0; i < 8; ++i) {
        const glm::dvec4 clip = clipFromWorld * glm::dvec4(worldBounds.corner(i), 1.0);
        outside[0] += clip.x < -clip.w ? 1 : 0;
        outside[1] += clip.x > clip.w ? 1 : 0;
        outside[2] += clip.y < -clip.w ? 1 : 0;
        outside[3] += clip.y > clip.w ? 1 : 0;
        outside[4] += clip.z < 0.0 ? 1 : 0;     // beyond the far plane
        outside[5] += clip.z > clip.w ? 1 : 0;  // before the near plane
    }
    return std::none_of(std::begin(outside), std::end(outside),
                        [](int count) { return count == 8; });
}

std::vector<glm::dvec2> beamOutline(const SpotLight& lamp, const Camera& camera, int width,
                                    int height) {
    // A direction has a vanishing point in a perspective picture only.
    const bool directions = !std::isfinite(lamp.rangeMetres) && !camera.isOrthographic();
    std::vector<Corner> corners = {Corner(lamp.frame.position, 1.0)};
    std::vector<std::pair<std::size_t, std::size_t>> edges;
    const std::vector<Corner> ring = endRing(lamp, directions);
    for (std::size_t i = 0; i < ring.size(); ++i) {
        corners.push_back(ring[i]);
        edges.emplace_back(0, i + 1);
        edges.emplace_back(i + 1, (i + 1) % ring.size() + 1);
    }

    // Depth before the camera, less the near plane; for directions their share of the view axis.
    const glm::dvec3 axis = camera.frame.forward();
    const auto before = [&](const Corner& corner) {
        const double share =
            glm::dot(axis, glm::dvec3(corner)) - corner.w * glm::dot(axis, camera.frame.position);
        return share - corner.w * camera.nearMetres - (1.0 - corner.w) * 1e-6;
    };
    const glm::dmat4 clip = clipFromWorld(camera, width, height);
    std::vector<glm::dvec2> points;
    const auto project = [&](const Corner& corner) {
        const glm::dvec4 place = clip * corner;
        points.emplace_back((place.x / place.w + 1.0) * 0.5 * width,
                            (place.y / place.w + 1.0) * 0.5 * height);
    };
    for (const Corner& corner : corners) {
        if (before(corner) >= 0.0) {
            project(corner);
        }
    }
    for (const auto& [from, to] : edges) {
        const double a = before(corners[from]);
        const double b = before(corners[to]);
        if ((a < 0.0) != (b < 0.0)) {
            project(glm::mix(corners[from], corners[to], a / (a - b)));
        }
    }
    return convexHull(std::move(points));
}

std::vector<glm::dvec2> thinBeamOutline(const SpotLight& lamp, const Camera& camera, int width,
                                        int height, double pixels) {
    constexpr double kFirstMetres = 1e-3;
    constexpr double kLastMetres = 1e5;
    constexpr double kStep = 1.25;
    const double pixelsAtUnit = 0.5 * height / viewHalfExtent(camera, width, height).y;
    const double widening = 2.0 * std::tan(drawnConeAngle(lamp));
    SpotLight thin = lamp;
    thin.rangeMetres = 0.0;
    const double last = std::min(lamp.rangeMetres, kLastMetres);
    for (double z = kFirstMetres; z < last; z *= kStep) {
        const glm::dvec3 point = lamp.frame.position + z * lamp.frame.forward();
        const double depth =
            camera.isOrthographic() ? 1.0 : glm::distance(point, camera.frame.position);
        if (widening * z * pixelsAtUnit < pixels * depth) {
            thin.rangeMetres = kStep * z;
        }
    }
    if (thin.rangeMetres >= last) {
        thin.rangeMetres = lamp.rangeMetres;
    }
    return thin.rangeMetres > 0.0 ? beamOutline(thin, camera, width, height)
                                  : std::vector<glm::dvec2>();
}

}  // namespace ribalta
