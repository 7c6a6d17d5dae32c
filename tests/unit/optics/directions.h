// Directions by angles, for tests of what surfaces reflect.
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>

namespace ribalta::test {

/// A unit vector at an angle to +z whose cosine is given, turned about it by `azimuth` radians.
inline glm::dvec3 direction(double cosine, double azimuth) {
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

}  // namespace ribalta::test
