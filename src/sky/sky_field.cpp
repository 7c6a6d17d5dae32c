// Quadrature over directions and along rays; single scattering on it.
#include "sky/sky_field.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "sky/sky_air.h"

namespace ribalta {
namespace {

/// Angles from the horizon, 0..span, that are dense near it.
void addAngles(double horizon, double span, int count, SkyDirections& directions) {
    const GaussRule rule = gaussRule(count);
    for (std::size_t i = 0; i < rule.places.size(); ++i) {
        const double u = rule.places[i];
        const double angle = horizon + span * u * u;
        directions.mu.push_back(std::cos(angle));
        directions.weights.push_back(rule.weights[i] * std::abs(span) * 2.0 * u * std::sin(angle));
    }
}

/// Sums of the nodes' light, without the phase functions.
struct Scattered {
    glm::dvec3 rayleigh{0.0};
    glm::dvec3 mie{0.0};
};

Scattered litBySun(const OpticalLengthTable& table, const shader::Air& air, const AirPath& path,
                   const std::vector<PathNode>& nodes) {
    Scattered sum;
    for (const PathNode& node : nodes) {
        const double muS =
            shader::sunCosineAlong(air, path.height, path.muS, path.nu, node.t, node.height);
        const glm::dvec3 sun = transmittance(table.atmosphere(), table.toTop(node.height, muS));
        sum.rayleigh += node.rayleigh * sun;
        sum.mie += node.mie * sun;
    }
    return sum;
}

bool sameCuts(const std::vector<PathPiece>& a, const std::vector<PathPiece>& b) {
    return a.size() == b.size() &&
           std::equal(a.begin(), a.end(), b.begin(), [](const PathPiece& x, const PathPiece& y) {
               return x.first == y.first && x.last == y.last && x.lit == y.lit;
           });
}

}  // namespace

SkyDirections directionsAt(const Atmosphere& atmosphere, double height,
                           const DirectionCounts& counts) {
    const shader::Air air = airOf(atmosphere);
    const double dip = std::atan2(std::sqrt(shader::airSquare(air, height)), air.groundRadius);
    const double horizon = 0.5 * kPi + dip;
    SkyDirections directions;
    addAngles(horizon, -horizon, counts.above, directions);
    addAngles(horizon, kPi - horizon, counts.below, directions);
    const int last = counts.azimuths - 1;
    for (int j = 0; j <= last; ++j) {
        directions.cosAzimuths.push_back(std::cos(kPi * j / last));
        directions.azimuthWeights.push_back((j == 0 || j == last ? 1.0 : 2.0) * kPi / last);
    }
    return directions;
}

void addNodes(const OpticalLengthTable& table, const AirPath& path, const PathPiece& piece,
              const GaussRule& rule, std::vector<PathNode>& nodes) {
    const Atmosphere& atmosphere = table.atmosphere();
    const shader::Air air = airOf(atmosphere);
    const double length = piece.last - piece.first;
    for (std::size_t i = 0; i < rule.places.size(); ++i) {
        const double u = rule.places[i];
        PathNode node;
        node.t = piece.risesFromFirst ? piece.first + length * u * u : piece.last - length * u * u;
        node.height =
            std::clamp(shader::heightAlong(air, path.height, path.mu, node.t), 0.0, air.top);
        const glm::dvec3 weight =
            rule.weights[i] * length * 2.0 * u *
            transmittance(atmosphere, table.along(path.height, path.mu, node.t, path.ground));
        node.rayleigh =
            weight * shader::airDensity(node.height, air.rayleighHeight) * air.rayleighScattering;
        node.mie = weight * shader::airDensity(node.height, air.mieHeight) * air.mieScattering;
        nodes.push_back(node);
    }
}

std::vector<glm::dvec3> firstOrderField(const OpticalLengthTable& table, double height, double muS,
                                        const SkyDirections& directions,
                                        const GaussRule& ruleAlong) {
    const Atmosphere& atmosphere = table.atmosphere();
    const shader::Air air = airOf(atmosphere);
    std::vector<glm::dvec3> field;
    field.reserve(directions.count());
    for (const double mu : directions.mu) {
        // Rays of one height and mu share their nodes unless the planet's shadow cuts them apart.
        std::vector<PathPiece> cuts;
        std::vector<PathNode> nodes;
        for (const double cosAzimuth : directions.cosAzimuths) {
            const AirPath path = airPathTowards(atmosphere, height, mu, muS, cosAzimuth);
            std::vector<PathPiece> pieces = piecesOf(atmosphere, path);
            if (!sameCuts(pieces, cuts)) {
                nodes.clear();
                for (const PathPiece& piece : pieces) {
                    if (piece.lit) {
                        addNodes(table, path, piece, ruleAlong, nodes);
                    }
                }
                cuts = std::move(pieces);
            }
            const Scattered sum = litBySun(table, air, path, nodes);
            field.push_back(shader::phaseRayleigh(path.nu) * sum.rayleigh +
                            shader::phaseCornetteShanks(path.nu, air.mieG) * sum.mie);
        }
    }
    return field;
}

glm::dvec3 sunTransmittance(const OpticalLengthTable& table, double height, double muS) {
    if (shader::hitsGround(airOf(table.atmosphere()), height, muS)) {
        return glm::dvec3(0.0);
    }
    return transmittance(table.atmosphere(), table.toTop(height, muS));
}

GroundView groundView(const OpticalLengthTable& table, const AirPath& path) {
    const Atmosphere& atmosphere = table.atmosphere();
    const double muS =
        shader::sunCosineAlong(airOf(atmosphere), path.height, path.muS, path.nu, path.length, 0.0);
    return {muS,
            atmosphere.groundAlbedo / kPi *
                transmittance(atmosphere, table.along(path.height, path.mu, path.length, true))};
}

glm::dvec3 sunIrradiance(const OpticalLengthTable& table, double muS) {
    return std::max(muS, 0.0) * sunTransmittance(table, 0.0, muS);
}

glm::dvec3 irradianceOf(const SkyDirections& directions, std::span<const glm::dvec3> field) {
    const std::size_t turns = directions.cosAzimuths.size();
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < directions.mu.size(); ++i) {
        for (std::size_t j = 0; j < turns; ++j) {
            sum += std::max(directions.mu[i], 0.0) * directions.weights[i] *
                   directions.azimuthWeights[j] * field[i * turns + j];
        }
    }
    return sum;
}

}  // namespace ribalta
