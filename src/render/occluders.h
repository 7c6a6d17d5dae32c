// Occluders: the few large flat surfaces of a view, walls and floors, that may hide whole beams.
// For leaving lamps out before anything is drawn; not a depth buffer.
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "render/draw_list.h"
#include "scene/camera.h"
#include "scene/light.h"
#include "scene/scene.h"

namespace ribalta {

/// An opaque, flat, convex piece of a surface as the camera sees it.
struct Occluder {
    glm::dvec3 point{0.0};            ///< on it, world
    glm::dvec3 towardsCamera{0.0};    ///< its unit normal on the camera's side
    std::vector<glm::dvec2> outline;  ///< pixels, y up; counter-clockwise, not cut at the picture
};

/// The largest in the picture, at most eight; none that covers less than a hundredth of it.
std::vector<Occluder> listOccluders(const Scene& scene, const std::vector<DrawItem>& draws,
                                    const std::vector<bool>& visible, const Camera& camera,
                                    int width, int height);

/// Whether all of the beam that is in the picture, air and surfaces, lies behind the occluder.
/// `outline` is the beam's (see beamOutline).
bool hides(const Occluder& occluder, const SpotLight& lamp, const std::vector<glm::dvec2>& outline,
           int width, int height);

/// Whether all of the beam lies beyond the camera's far plane.
bool isBeyondFarPlane(const SpotLight& lamp, const Camera& camera);

}  // namespace ribalta
