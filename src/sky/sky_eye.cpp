#include "sky/sky_eye.h"

#include <algorithm>
#include <cmath>

namespace ribalta {

SkyEye skyEye(const Atmosphere& air, double altitudeMetres, const glm::dvec3& towardsSun,
              const glm::dvec3& position) {
    // Relative to the ground's point below the origin; no two large numbers are subtracted.
    const double radius = air.groundRadiusMetres;
    const glm::dvec3 place = position + glm::dvec3(0.0, altitudeMetres, 0.0);
    const double square = glm::dot(place, place) + 2.0 * radius * place.y;
    const glm::dvec3 fromCentre = place + glm::dvec3(0.0, radius, 0.0);
    const double height = square / (std::sqrt(std::max(radius * radius + square, 0.0)) + radius);
    SkyEye eye;
    eye.heightMetres = std::max(height, 0.0);
    eye.belowMetres = std::max(-height, 0.0);
    const double size = glm::length(fromCentre);
    eye.zenith = size > 0.0 ? fromCentre / size : eye.zenith;
    eye.muS = std::clamp(glm::dot(eye.zenith, towardsSun), -1.0, 1.0);
    return eye;
}

// Where a ray to the horizon touches the ground on the side away from the sun, the sun is lower by
// as much as the horizon is at the eye; farther on, the ray rises over the horizon as fast as the
// sun sinks.
bool seesPlanetShadow(const Atmosphere& air, const SkyEye& eye) {
    const double radius = air.groundRadiusMetres;
    const double height = eye.heightMetres;
    return eye.muS * (radius + height) < std::sqrt(height * (2.0 * radius + height));
}

}  // namespace ribalta
