#include "viewer/navigate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/bearing.h"

namespace ribalta {
namespace {

// Short of straight up or down, where left and right would lose their sense.
constexpr double kSteepest = 0.5 * std::numbers::pi - 1e-3;
constexpr double kNearestMetres = 1e-6;
constexpr double kFarthestMetres = 1e9;

// A direction turned to the right and upwards.
glm::dvec3 turned(const glm::dvec3& direction, glm::dvec2 radians) {
    Bearing bearing = bearingOf(direction);
    bearing.azimuth += radians.x;
    bearing.elevation = std::clamp(bearing.elevation + radians.y, -kSteepest, kSteepest);
    return directionOf(bearing);
}

// A camera that is moved by hand follows its node no more.
void detach(Viewpoint& view) {
    view.camera.node = -1;
}

void aim(Viewpoint& view) {
    detach(view);
    view.camera.frame = lookAt(view.camera.frame.position, view.pivot);
}

}  // namespace

Viewpoint viewpointOf(const Camera& camera, const Bounds& scene) {
    const Frame& frame = camera.frame;
    double ahead = 1.0;
    if (!scene.isEmpty()) {
        const double size = glm::length(scene.halfSize());
        const double toMiddle = glm::dot(scene.centre() - frame.position, frame.forward());
        ahead = std::max({toMiddle, 0.05 * size, 10.0 * camera.nearMetres});
    }
    return {camera, frame.position + ahead * frame.forward()};
}

void follow(Viewpoint& view, const Camera& posed) {
    const double distance = view.distance();
    view.camera = posed;
    view.pivot = posed.frame.position + distance * posed.frame.forward();
}

void orbit(Viewpoint& view, glm::dvec2 radians) {
    const double distance = view.distance();
    // To go to the right is to look to the left.
    view.camera.frame.position =
        view.pivot - distance * turned(view.camera.frame.forward(), -radians);
    aim(view);
}

void lookAround(Viewpoint& view, glm::dvec2 radians) {
    const double distance = view.distance();
    view.pivot =
        view.camera.frame.position + distance * turned(view.camera.frame.forward(), radians);
    aim(view);
}

void pan(Viewpoint& view, glm::dvec2 pixels, glm::ivec2 size) {
    if (size.x <= 0 || size.y <= 0) {
        return;
    }
    const glm::dvec2 half = viewHalfExtent(view.camera, size.x, size.y);
    const double depth = view.camera.isOrthographic() ? 1.0 : view.distance();
    const double metresAPixel = 2.0 * half.y * depth / size.y;
    const Frame& frame = view.camera.frame;
    const glm::dvec3 moved = metresAPixel * (-pixels.x * frame.right() + pixels.y * frame.up());
    detach(view);
    view.camera.frame.position += moved;
    view.pivot += moved;
}

void dolly(Viewpoint& view, double factor) {
    detach(view);
    if (auto* lens = std::get_if<OrthographicLens>(&view.camera.lens)) {
        lens->halfWidth *= factor;
        lens->halfHeight *= factor;
        return;
    }
    const double distance = std::clamp(view.distance() * factor, kNearestMetres, kFarthestMetres);
    view.camera.frame.position = view.pivot - distance * view.camera.frame.forward();
}

void walk(Viewpoint& view, const glm::dvec3& metres) {
    const Frame& frame = view.camera.frame;
    const glm::dvec3 moved = metres.x * frame.right() + metres.y * glm::dvec3(0.0, 1.0, 0.0) +
                             metres.z * frame.forward();
    detach(view);
    view.camera.frame.position += moved;
    view.pivot += moved;
}

void frame(Viewpoint& view, const Bounds& bounds, double aspectRatio) {
    if (bounds.isEmpty()) {
        return;
    }
    const double radius = std::max(1e-3, glm::length(bounds.halfSize()));
    detach(view);
    view.pivot = bounds.centre();
    double distance = 2.0 * radius;
    if (auto* lens = std::get_if<OrthographicLens>(&view.camera.lens)) {
        lens->halfHeight = radius / std::min(1.0, aspectRatio);
        lens->halfWidth = lens->halfHeight * aspectRatio;
    } else {
        constexpr int kTall = 1 << 12;
        const glm::dvec2 half =
            viewHalfExtent(view.camera, std::max(1, int(kTall * aspectRatio)), kTall);
        distance = radius / std::sin(std::atan(std::min(half.x, half.y)));
    }
    view.camera.frame.position = view.pivot - distance * view.camera.frame.forward();
    view.camera.nearMetres = std::min(view.camera.nearMetres, 0.01 * distance);
    view.camera.farMetres = std::max(view.camera.farMetres, distance + radius);
}

}  // namespace ribalta
