// SetUp: one case of the stress test as plain data: lamps, rectangles, haze, a camera, a picture.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "image/image.h"
#include "scene/camera.h"
#include "scene/haze.h"
#include "scene/light.h"

namespace ribalta::stress {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A rectangle that stops rays and casts shadows, seen from both sides.
struct Rectangle {
    glm::dvec3 centre{0.0};           ///< metres, world
    glm::dvec3 halfU{1.0, 0.0, 0.0};  ///< from the centre to the middle of a side
    glm::dvec3 halfV{0.0, 1.0, 0.0};  ///< perpendicular to halfU
};

struct SetUp {
    std::uint64_t seed = 0;
    int number = 0;
    int kind = 0;                  ///< into kindNames()
    std::vector<SpotLight> lamps;  ///< LightMap::image is into lightMaps()
    std::vector<Rectangle> rectangles;
    Camera camera;
    Haze haze;
    int width = 48;  ///< pixels
    int height = 36;
    int sheets = 24;
};

/// The pictures that lamps of set-ups may project, all of one size: smooth, chequered, spokes.
const std::vector<Image>& lightMaps();

/// The whole set-up turned by `rotation` (orthonormal) and then moved by `metres`.
SetUp moved(const SetUp& setUp, const glm::dmat3& rotation, const glm::dvec3& metres);

/// All numbers of a set-up, in as many lines as it takes; doubles with all their digits.
std::string describe(const SetUp& setUp);

}  // namespace ribalta::stress
