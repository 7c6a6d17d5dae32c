// Bearing: a direction by two angles, as people point.
#pragma once

#include <cmath>

#include <glm/glm.hpp>

namespace ribalta {

/// North is -Z, east +X, the zenith +Y.
struct Bearing {
    double azimuth = 0.0;    ///< from north through east, radians
    double elevation = 0.0;  ///< above the horizon, radians
};

/// Of a direction of any length; azimuth -pi..pi.
inline Bearing bearingOf(const glm::dvec3& direction) {
    return {std::atan2(direction.x, -direction.z),
            std::atan2(direction.y, std::hypot(direction.x, direction.z))};
}

/// Unit.
inline glm::dvec3 directionOf(const Bearing& bearing) {
    const double level = std::cos(bearing.elevation);
    return {level * std::sin(bearing.azimuth), std::sin(bearing.elevation),
            -level * std::cos(bearing.azimuth)};
}

}  // namespace ribalta
