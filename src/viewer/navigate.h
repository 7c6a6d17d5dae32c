// Moves of a camera as a person asks for them: around a point, sideways, nearer, on foot. A camera
// that is moved so follows its node no more. No window.
#pragma once

#include <glm/glm.hpp>

#include "scene/bounds.h"
#include "scene/camera.h"

namespace ribalta {

/// A camera and the point that it turns around.
struct Viewpoint {
    Camera camera;
    glm::dvec3 pivot{0.0};  ///< world metres

    double distance() const { return glm::distance(camera.frame.position, pivot); }
    bool operator==(const Viewpoint&) const = default;
};

/// The pivot lies ahead in the middle of the scene, as far as the camera sees it.
Viewpoint viewpointOf(const Camera& camera, const Bounds& scene);

/// Gives the view its camera as that is posed; the pivot stays as far ahead.
void follow(Viewpoint& view, const Camera& posed);

/// Turns around the pivot, `radians` to the right and upwards; the horizon stays level, and the
/// camera does not tip over the top.
void orbit(Viewpoint& view, glm::dvec2 radians);
/// The same where the camera stands: it looks around.
void lookAround(Viewpoint& view, glm::dvec2 radians);
/// Moves sideways so that what lies at the pivot's depth follows a pointer that moves by `pixels`
/// (right, down) in a picture of `size`.
void pan(Viewpoint& view, glm::dvec2 pixels, glm::ivec2 size);
/// Goes towards the pivot: `factor` times as near (an orthographic camera shows as much less).
void dolly(Viewpoint& view, double factor);
/// Goes by `metres` right, up (of the world) and ahead, and takes the pivot along.
void walk(Viewpoint& view, const glm::dvec3& metres);
/// Stands back, looking the way it looks, until all of `bounds` is in view.
void frame(Viewpoint& view, const Bounds& bounds, double aspectRatio);

}  // namespace ribalta
