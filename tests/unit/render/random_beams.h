// Random lamps, cameras and points inside beams: what tests of a lamp's reach draw from.
#pragma once

#include <optional>
#include <random>

#include <glm/glm.hpp>

#include "scene/camera.h"
#include "scene/light.h"

namespace ribalta::test {

class RandomBeams {
  public:
    explicit RandomBeams(unsigned seed) : engine_(seed) {}

    double between(double low, double high);
    glm::dvec3 inCube(double halfSide);
    /// A unit vector, even over the sphere.
    glm::dvec3 direction();
    bool chance(double probability) { return between(0.0, 1.0) < probability; }

    /// Cones and pyramids of 0.5 to 80 degrees within 10 m of the origin, half of them endless.
    SpotLight lamp();
    /// Perspective (endless or not) or orthographic, within 10 m of the origin; now and then at the
    /// lamp's apex, inside its beam, or looking along or against its axis.
    Camera camera(const SpotLight& lamp);
    /// A point inside the beam, its range included, up to `farthest` metres of depth away.
    glm::dvec3 pointInBeam(const SpotLight& lamp, double farthest);

  private:
    std::mt19937 engine_;
};

/// Where the camera shows a point, in pixels with y up; none where it is before the near plane or
/// beyond the far one.
std::optional<glm::dvec2> project(const Camera& camera, int width, int height,
                                  const glm::dvec3& point);

}  // namespace ribalta::test
