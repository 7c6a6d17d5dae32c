#include "reference/sky_daylight.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/gauss_rule.h"
#include "base/parallel_for.h"
#include "sky/sky_field.h"

namespace ribalta {
namespace {

constexpr DirectionCounts kAround{32, 24, 33};
constexpr int kStripsOfSun = 32;
constexpr int kPointsOfSun = 64;

// The disc in level strips, each as bright as the other; those below the horizon are not seen.
glm::dvec3 sunlight(const SkySight& sight) {
    const SkyOverScene& sky = sight.sky();
    const double elevation = std::asin(std::clamp(sky.towardsSun.y, -1.0, 1.0));
    const GaussRule rule = gaussRule(kStripsOfSun);
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < rule.places.size(); ++i) {
        const double angle = std::numbers::pi * rule.places[i];
        const double mu = std::sin(elevation + sky.air.sunAngularRadius * std::cos(angle));
        const SkyRay ray{sky.altitudeMetres, mu, mu, 1.0};
        const std::optional<AirPath> path = airPath(sky.air, ray);
        if (path && path->ground) {
            continue;
        }
        const glm::dvec3 through =
            path ? transmittance(sky.air,
                                 opticalLengths(sky.air, path->height, path->mu, path->length))
                 : glm::dvec3(1.0);
        // A chord's length times the strip's height, of the disc's area.
        sum += rule.weights[i] * 2.0 * std::sin(angle) * std::sin(angle) * through;
    }
    return sum * sky.air.sunIlluminanceLux;
}

// Along a spiral by the golden angle, each point standing for as much of the disc as the others.
std::vector<glm::dvec3> discOf(const glm::dvec3& middle, double radius) {
    const glm::dvec3 axis =
        std::abs(middle.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 right = glm::normalize(glm::cross(middle, axis));
    const glm::dvec3 up = glm::cross(right, middle);
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    std::vector<glm::dvec3> points;
    for (int i = 0; i < kPointsOfSun; ++i) {
        const double angle = radius * std::sqrt((i + 0.5) / kPointsOfSun);
        points.push_back(std::cos(angle) * middle +
                         std::sin(angle) *
                             (std::cos(i * golden) * right + std::sin(i * golden) * up));
    }
    return points;
}

}  // namespace

SkyDaylight::SkyDaylight(const SkySight& sight)
    : towardsSun_(sight.sky().towardsSun),
      sunDisc_(discOf(towardsSun_, sight.sky().air.sunAngularRadius)),
      sunLamp_(sight.sky().sunLamp),
      sunLux_(sunlight(sight)) {
    const SkyOverScene& sky = sight.sky();
    const double height = std::clamp(sky.altitudeMetres, 0.0, sky.air.topMetres);
    const SkyDirections directions = directionsAt(sky.air, height, kAround);
    const glm::dvec3 level(towardsSun_.x, 0.0, towardsSun_.z);
    const glm::dvec3 sunward =
        glm::length(level) > 1e-9 ? glm::normalize(level) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 aside = glm::cross(sunward, glm::dvec3(0.0, 1.0, 0.0));
    const std::size_t turns = directions.cosAzimuths.size();
    parts_.resize(2 * directions.count());
    parallelFor(directions.count(), [&](std::size_t i) {
        const double mu = directions.mu[i / turns];
        const double sine = std::sqrt(1.0 - mu * mu);
        const double cosine = directions.cosAzimuths[i % turns];
        const double side = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
        const double nu = mu * towardsSun_.y + sine * cosine * glm::length(level);
        const SkyLight light = sight.along({height, mu, towardsSun_.y, nu});
        // Half of the light comes from each side of the sun.
        const glm::dvec3 lux = 0.5 * directions.weights[i / turns] *
                               directions.azimuthWeights[i % turns] * (light.air + light.ground) *
                               sky.air.sunIlluminanceLux;
        for (int k = 0; k < 2; ++k) {
            parts_[2 * i + std::size_t(k)] = {
                sine * (cosine * sunward + (k == 0 ? side : -side) * aside) +
                    glm::dvec3(0.0, mu, 0.0),
                lux};
        }
    });
}

glm::dvec3 SkyDaylight::irradiance(const glm::dvec3& normal) const {
    glm::dvec3 sum(0.0);
    for (const Part& part : parts_) {
        sum += std::max(glm::dot(part.direction, normal), 0.0) * part.lux;
    }
    return sum;
}

}  // namespace ribalta
