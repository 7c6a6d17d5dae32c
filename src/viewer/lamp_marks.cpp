#include "viewer/lamp_marks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

namespace ribalta {

std::optional<Projected> project(const Camera& camera, glm::ivec2 size, const glm::dvec3& point) {
    const glm::dvec3 view(viewFromWorld(camera) * glm::dvec4(point, 1.0));
    if (-view.z < camera.nearMetres) {
        return std::nullopt;
    }
    const glm::dvec4 clip = clipFromWorld(camera, size.x, size.y) * glm::dvec4(point, 1.0);
    const glm::dvec2 half = 0.5 * glm::dvec2(size);
    return Projected{half + half * glm::dvec2(clip.x, -clip.y) / clip.w, -view.z};
}

std::optional<glm::dvec3> placeOf(const Scene& scene, const LampId& lamp) {
    struct Standing {
        std::optional<glm::dvec3> operator()(const SpotLight& spot) { return spot.frame.position; }
        std::optional<glm::dvec3> operator()(const PointLight& point) { return point.position; }
        std::optional<glm::dvec3> operator()(const DirectionalLight&) { return std::nullopt; }
    };
    return visitLamp(scene, lamp, Standing{});
}

std::optional<glm::dvec3> aimOf(const Scene& scene, const LampId& lamp, const Bounds& bounds) {
    if (lamp.kind != LampId::Kind::kSpot) {
        return std::nullopt;
    }
    const Frame& frame = scene.spotLights[std::size_t(lamp.index)].frame;
    const glm::dvec3 ahead = frame.forward();
    const double size = bounds.isEmpty() ? 5.0 : glm::length(bounds.halfSize());
    double metres = size;
    if (!bounds.isEmpty() && ahead.y < 0.0 && frame.position.y > bounds.low.y) {
        metres = std::min(4.0 * size, (bounds.low.y - frame.position.y) / ahead.y);
    }
    return frame.position + metres * ahead;
}

Frame turned(const Frame& frame, const glm::dvec3& direction) {
    const glm::dvec3 from = frame.forward();
    const glm::dvec3 to = glm::normalize(direction);
    const glm::dvec3 axis = glm::cross(from, to);
    const double sine = glm::length(axis);
    const double angle = std::atan2(sine, glm::dot(from, to));
    // Half a turn goes about the frame's own up.
    const glm::dvec3 about = sine > 1e-12 ? axis / sine : frame.up();
    const glm::dquat turn = glm::angleAxis(angle, about);
    // Through lookAt's care for orthonormal columns.
    return rigidFrame(glm::translate(glm::dmat4(1.0), frame.position) *
                      glm::dmat4(glm::mat3_cast(turn) * frame.worldFromLocal));
}

double sharpnessOf(const SpotLight& spot) {
    return spot.outerConeAngle > 0.0
               ? std::clamp(spot.innerConeAngle / spot.outerConeAngle, 0.0, 1.0)
               : 1.0;
}

int lampAt(const StageView& stage, const Camera& camera, glm::ivec2 size, glm::dvec2 at,
           double reach) {
    int nearest = -1;
    double nearestDepth = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < stage.lamps().size(); ++i) {
        const std::optional<glm::dvec3> place = placeOf(stage.scene(), stage.lamps()[i]);
        const std::optional<Projected> mark =
            place ? project(camera, size, *place) : std::optional<Projected>();
        if (mark && glm::distance(mark->at, at) <= reach && mark->depth < nearestDepth) {
            nearest = int(i);
            nearestDepth = mark->depth;
        }
    }
    return nearest;
}

}  // namespace ribalta
