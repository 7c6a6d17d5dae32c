// Optical lengths by adaptive quadrature, and tabulated.
#include "sky/optical_length.h"

#include <cmath>

#include "base/adaptive_integral.h"
#include "base/cubic_weights.h"
#include "base/parallel_for.h"
#include "sky/sky_air.h"

namespace ribalta {
namespace {

// Where the air gets thin quickly pieces begin short: near the lowest point.
std::vector<double> cutsAround(double lowest, double distance) {
    std::vector<double> cuts = {0.0};
    const double turn = std::clamp(lowest, 0.0, distance);
    for (const double part : {0.4375, 0.75, 0.9375, 1.0}) {
        cuts.push_back(part * turn);
    }
    for (const double part : {0.0625, 0.25, 0.5625, 1.0}) {
        cuts.push_back(turn + part * (distance - turn));
    }
    return cuts;
}

}  // namespace

glm::dvec2 opticalLengths(const Atmosphere& atmosphere, double height, double mu, double distance) {
    constexpr double kRelative = 1e-9;  // of the weaker of two rules
    const shader::Air air = airOf(atmosphere);
    const auto densities = [&](double t) -> std::array<double, 2> {
        const double there = shader::heightAlong(air, height, mu, t);
        return {shader::airDensity(there, air.rayleighHeight),
                shader::airDensity(there, air.mieHeight)};
    };
    const std::vector<double> cuts =
        cutsAround(shader::distanceToLowest(air, height, mu), distance);
    const std::array<double, 2> lengths = integrateAdaptively<2>(densities, cuts, kRelative);
    return {lengths[0], lengths[1]};
}

glm::dvec3 transmittance(const Atmosphere& atmosphere, const glm::dvec2& lengths) {
    return shader::airTransmittance(airOf(atmosphere), lengths.x, lengths.y);
}

OpticalLengthTable::OpticalLengthTable(const Atmosphere& atmosphere, int heights, int cosines)
    : atmosphere_(atmosphere),
      heights_(heights),
      cosines_(cosines),
      logs_(std::size_t(heights) * std::size_t(cosines)) {
    const shader::Air air = airOf(atmosphere);
    const double radius = air.groundRadius;
    const double topSquare = shader::airSquare(air, air.top);
    parallelFor(std::size_t(heights_), [&](std::size_t row) {
        // Even in the distance to the horizon, rho.
        const double part = double(row) / (heights_ - 1);
        const double square = topSquare * part * part;
        const double height =
            std::min(square / (std::sqrt(radius * radius + square) + radius), air.top);
        const double shortest = air.top - height;
        const double longest = std::sqrt(square) + std::sqrt(topSquare);
        for (int i = 0; i < cosines_; ++i) {
            const double distance =
                std::max(shortest + (longest - shortest) * i / (cosines_ - 1), 1e-6 * air.top);
            const double mu = std::clamp(
                (topSquare - square - distance * distance) / (2.0 * (radius + height) * distance),
                -1.0, 1.0);
            const glm::dvec2 lengths = opticalLengths(atmosphere, height, mu, distance);
            // A scale height of less than 1/745 of the top leaves nothing that a double can hold.
            logs_[row * std::size_t(cosines_) + std::size_t(i)] =
                glm::log(glm::max(lengths / distance, glm::dvec2(1e-300)));
        }
    });
}

glm::dvec2 OpticalLengthTable::toTop(double height, double mu) const {
    const shader::Air air = airOf(atmosphere_);
    const double top = shader::airSquare(air, air.top);
    const double square = std::max(shader::airSquare(air, height), 0.0);
    const double distance = shader::distanceToTop(air, height, mu);
    const double shortest = air.top - height;
    const double longest = std::sqrt(square) + std::sqrt(top);
    const CubicWeights row = cubicWeights((heights_ - 1) * std::sqrt(square / top), heights_);
    const CubicWeights column =
        cubicWeights((cosines_ - 1) * (distance - shortest) / (longest - shortest), cosines_);
    glm::dvec2 sum(0.0);
    for (std::size_t r = 0; r < 4; ++r) {
        const glm::dvec2* const logs = &logs_[(std::size_t(row.first) + r) * std::size_t(cosines_) +
                                              std::size_t(column.first)];
        sum += row.weights[r] * (column.weights[0] * logs[0] + column.weights[1] * logs[1] +
                                 column.weights[2] * logs[2] + column.weights[3] * logs[3]);
    }
    return distance * glm::exp(sum);
}

glm::dvec2 OpticalLengthTable::along(double height, double mu, double distance, bool ground) const {
    const shader::Air air = airOf(atmosphere_);
    const double there = std::clamp(shader::heightAlong(air, height, mu, distance), 0.0, air.top);
    const double muThere = shader::cosineAlong(air, height, mu, distance, there);
    // Backwards along a ray that hits the ground, so that both look up.
    const glm::dvec2 lengths = ground ? toTop(there, -muThere) - toTop(height, -mu)
                                      : toTop(height, mu) - toTop(there, muThere);
    return glm::max(lengths, glm::dvec2(0.0));
}

}  // namespace ribalta
