// Marks of lamps over the picture: where they are, which one is under the pointer, where the chosen
// one aims.
#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "viewer/stage_view.h"

namespace ribalta {

/// A place of the world in a picture.
struct Projected {
    glm::dvec2 at{0.0};  ///< pixels from the upper left
    double depth = 0.0;  ///< metres along the view axis
};

/// None where it is behind the camera.
std::optional<Projected> project(const Camera& camera, glm::ivec2 size, const glm::dvec3& point);

/// Where a spot or a point light stands; a directional one stands nowhere.
std::optional<glm::dvec3> placeOf(const Scene& scene, const LampId& lamp);

/// Where a spot aims: its axis down to the lowest of the scene, or half as far as the scene is
/// wide. None for lamps of other kinds.
std::optional<glm::dvec3> aimOf(const Scene& scene, const LampId& lamp, const Bounds& bounds);

/// Turned the shortest way until it looks along `direction`, which is not zero: what it projects
/// does not roll.
Frame turned(const Frame& frame, const glm::dvec3& direction);

/// The share of a spot's cone that is as bright as its middle, 0..1.
double sharpnessOf(const SpotLight& spot);

/// The nearest lamp whose mark lies within `reach` pixels of a place of the picture; -1: none.
int lampAt(const StageView& stage, const Camera& camera, glm::ivec2 size, glm::dvec2 at,
           double reach);

}  // namespace ribalta
