// Orders of scattering, one after the other, on a grid of heights and suns.
#include "sky/sky_sources.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/check.h"
#include "base/cubic_weights.h"
#include "base/parallel_for.h"
#include "sky/phase_projection.h"
#include "sky/sky_air.h"

namespace ribalta {
namespace {

// What one order may be of the order before: no air and ground give back more than they take.
constexpr double kLargestRatio = 0.95;

/// The cosines of the sun over a path: lowest and highest.
glm::dvec2 sunsOver(const shader::Air& air, const AirPath& path) {
    constexpr int kSteps = 32;
    glm::dvec2 range(path.muS, path.muS);
    for (int i = 1; i <= kSteps; ++i) {
        const double t = path.length * i / kSteps;
        const double height = shader::heightAlong(air, path.height, path.mu, t);
        const double muS = shader::sunCosineAlong(air, path.height, path.muS, path.nu, t, height);
        range = glm::dvec2(std::min(range.x, muS), std::max(range.y, muS));
    }
    return range;
}

/// The angle that the longest way through the air goes around the planet.
double longestAngle(const Atmosphere& air) {
    return 2.0 * std::acos(air.groundRadiusMetres / (air.groundRadiusMetres + air.topMetres));
}

}  // namespace

SkyTableSizes coarseSkyTables() {
    SkyTableSizes sizes;
    sizes.heights = 14;
    sizes.suns = 48;
    sizes.zenithAngles = 25;
    sizes.azimuths = 13;
    sizes.firstDirections = {18, 12, 21};
    sizes.laterDirections = {12, 8, 9};
    sizes.nodesOfFirst = 14;
    sizes.nodesOfLater = 10;
    return sizes;
}

SkyTableSizes pictureSkyTables() {
    SkyTableSizes sizes;
    sizes.heights = 10;
    sizes.suns = 32;
    sizes.zenithAngles = 13;
    sizes.azimuths = 7;
    sizes.firstDirections = {10, 6, 11};
    sizes.laterDirections = {6, 5, 5};
    sizes.nodesOfFirst = 8;
    sizes.nodesOfLater = 6;
    return sizes;
}

SkySources::SkySources(const OpticalLengthTable& table, int orders, bool groundLightsAir,
                       const SkyTableSizes& sizes, std::span<const AirPath> paths)
    : table_(&table),
      groundLightsAir_(groundLightsAir),
      sizes_(sizes),
      alongFirst_(gaussRule(sizes.nodesOfFirst)),
      alongLater_(gaussRule(sizes.nodesOfLater)) {
    CHECK(orders >= 2);
    placeNodes();
    wantSuns(paths, orders);
    for (int order = 2; order <= orders; ++order) {
        makeOrder(order);
    }
}

SkySources::SkySources(const OpticalLengthTable& table, int orders, bool groundLightsAir,
                       const SkyTableSizes& sizes)
    : table_(&table),
      groundLightsAir_(groundLightsAir),
      sizes_(sizes),
      alongFirst_(gaussRule(sizes.nodesOfFirst)),
      alongLater_(gaussRule(sizes.nodesOfLater)) {
    CHECK(orders >= 2);
    placeNodes();
    wanted_.assign(std::size_t(orders - 1), std::vector<bool>(std::size_t(sizes_.suns), true));
    for (int order = 2; order <= orders; ++order) {
        makeOrder(order);
    }
}

SkySources::SkySources(const OpticalLengthTable& table, bool groundLightsAir,
                       const SkyTableSizes& sizes, Tables tables)
    : table_(&table),
      groundLightsAir_(groundLightsAir),
      sizes_(sizes),
      alongFirst_(gaussRule(sizes.nodesOfFirst)),
      alongLater_(gaussRule(sizes.nodesOfLater)),
      tables_(std::move(tables)) {
    placeNodes();
    const std::size_t size = heights_.size() * suns_.size() * directionSize();
    CHECK(!tables_.grids.empty() && tables_.irradiances.size() == tables_.grids.size());
    for (const Grid& grid : tables_.grids) {
        CHECK(grid.size() == size);
    }
    for (const std::vector<glm::dvec3>& irradiance : tables_.irradiances) {
        CHECK(irradiance.size() == suns_.size());
    }
    wanted_.assign(tables_.grids.size(), std::vector<bool>(suns_.size(), true));
}

void SkySources::placeNodes() {
    const Atmosphere& air = table_->atmosphere();
    for (int i = 0; i < sizes_.heights; ++i) {
        const double part = double(i) / (sizes_.heights - 1);
        heights_.push_back(air.topMetres * part * part);
    }
    // Dusk is over within a few sqrt(H / R) around the horizon; darkness once no two ways through
    // the air get around the planet any more.
    sunScale_ =
        std::clamp(std::sqrt(air.rayleighScaleHeightMetres / air.groundRadiusMetres), 0.01, 1.0);
    const double darkest = 2.0 * longestAngle(air);
    firstSun_ = std::asinh((darkest < 0.5 * kPi ? -std::sin(darkest) : -1.0) / sunScale_);
    lastSun_ = std::asinh(1.0 / sunScale_);
    for (int i = 0; i < sizes_.suns; ++i) {
        const double y = firstSun_ + (lastSun_ - firstSun_) * i / (sizes_.suns - 1);
        suns_.push_back(std::clamp(sunScale_ * std::sinh(y), -1.0, 1.0));
    }
}

std::size_t SkySources::directionSize() const {
    return std::size_t(sizes_.zenithAngles) * std::size_t(sizes_.azimuths) * 6;
}

double SkySources::sunPlace(double muS) const {
    return (std::asinh(muS / sunScale_) - firstSun_) / (lastSun_ - firstSun_) * (sizes_.suns - 1);
}

void SkySources::wantSuns(std::span<const AirPath> paths, int orders) {
    const shader::Air air = airOf(table_->atmosphere());
    wanted_.assign(std::size_t(orders - 1), std::vector<bool>(std::size_t(sizes_.suns), false));
    for (const AirPath& path : paths) {
        const glm::dvec2 range = sunsOver(air, path);
        // What cubics take, and one more for what lies between the steps.
        const int first = cubicWeights(sunPlace(range.x) - 1.0, sizes_.suns).first;
        const int last = cubicWeights(sunPlace(range.y) + 1.0, sizes_.suns).first + 3;
        for (int i = first; i <= last; ++i) {
            wanted_.back()[std::size_t(i)] = true;
        }
    }
    const double reach = longestAngle(table_->atmosphere());
    for (int order = orders - 1; order >= 2; --order) {
        for (int i = 0; i < sizes_.suns; ++i) {
            if (!wanted_[std::size_t(order - 1)][std::size_t(i)]) {
                continue;
            }
            const double angle = std::acos(suns_[std::size_t(i)]);
            const double low = std::cos(std::min(angle + reach, kPi));
            const double high = std::cos(std::max(angle - reach, 0.0));
            const int first = cubicWeights(sunPlace(low) - 1.0, sizes_.suns).first;
            const int last = cubicWeights(sunPlace(high) + 1.0, sizes_.suns).first + 3;
            for (int k = first; k <= last; ++k) {
                wanted_[std::size_t(order - 2)][std::size_t(k)] = true;
            }
        }
    }
}

void SkySources::makeOrder(int order) {
    const Atmosphere& air = table_->atmosphere();
    const std::vector<bool>& wanted = wanted_[std::size_t(order - 2)];
    std::vector<int> suns;
    for (int i = 0; i < sizes_.suns; ++i) {
        if (wanted[std::size_t(i)]) {
            suns.push_back(i);
        }
    }
    Grid grid(std::size_t(sizes_.heights) * std::size_t(sizes_.suns) * directionSize());
    std::vector<glm::dvec3> irradiances(std::size_t(sizes_.suns), glm::dvec3(0.0));
    for (int h = 0; h < sizes_.heights; ++h) {
        const double height = heights_[std::size_t(h)];
        const SkyDirections directions =
            directionsAt(air, height, order == 2 ? sizes_.firstDirections : sizes_.laterDirections);
        const PhaseProjection projection(directions, air.mieG, sizes_.zenithAngles,
                                         sizes_.azimuths);
        parallelFor(suns.size(), [&](std::size_t k) {
            const auto s = std::size_t(suns[k]);
            std::vector<glm::dvec3> light = field(order - 1, height, suns_[s], directions);
            if (h == 0) {
                irradiances[s] = irradianceOf(directions, light);
            }
            if (groundLightsAir_) {
                addGround(order - 1, height, suns_[s], directions, light);
            }
            projection.apply(light, {&grid[(std::size_t(h) * sizes_.suns + s) * directionSize()],
                                     directionSize()});
        });
        if (h == 0) {
            tables_.irradiances.push_back(irradiances);
        }
    }
    tables_.grids.push_back(std::move(grid));
}

std::vector<glm::dvec3> SkySources::field(int order, double height, double muS,
                                          const SkyDirections& directions) const {
    if (order == 1) {
        return firstOrderField(*table_, height, muS, directions, alongFirst_);
    }
    const Atmosphere& atmosphere = table_->atmosphere();
    const shader::Air air = airOf(atmosphere);
    std::vector<glm::dvec3> light;
    light.reserve(directions.count());
    for (const double mu : directions.mu) {
        std::vector<PathNode> nodes;
        for (const double cosAzimuth : directions.cosAzimuths) {
            const AirPath path = airPathTowards(atmosphere, height, mu, muS, cosAzimuth);
            if (nodes.empty()) {
                const double turn =
                    std::min(shader::distanceToLowest(air, height, mu), path.length);
                addNodes(*table_, path, {0.0, turn, false, true}, alongLater_, nodes);
                addNodes(*table_, path, {turn, path.length, true, true}, alongLater_, nodes);
            }
            light.push_back(march(tables_.grids[std::size_t(order - 2)], path, nodes));
        }
    }
    return light;
}

// Light that has been on its way `order` times, the last of them from the ground up.
void SkySources::addGround(int order, double height, double muS, const SkyDirections& directions,
                           std::vector<glm::dvec3>& field) const {
    const Atmosphere& atmosphere = table_->atmosphere();
    const std::size_t turns = directions.cosAzimuths.size();
    for (std::size_t i = 0; i < directions.mu.size(); ++i) {
        for (std::size_t j = 0; j < turns; ++j) {
            const AirPath path = airPathTowards(atmosphere, height, directions.mu[i], muS,
                                                directions.cosAzimuths[j]);
            if (path.endsOnGround) {
                field[i * turns + j] += groundLight(*table_, path, [&](double muSThere) {
                    return order == 1 ? sunIrradiance(*table_, muSThere)
                                      : irradiance(order - 1, muSThere);
                });
            }
        }
    }
}

glm::dvec3 SkySources::irradiance(int order, double muS) const {
    const std::vector<glm::dvec3>& values = tables_.irradiances.at(std::size_t(order - 1));
    const CubicWeights suns = cubicWeights(sunPlace(muS), sizes_.suns);
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < 4; ++i) {
        sum += suns.weights[i] * values[std::size_t(suns.first) + i];
    }
    return glm::max(sum, glm::dvec3(0.0));
}

glm::dvec3 SkySources::irradianceOfAll(bool closed, double muS) const {
    const int orders = int(tables_.irradiances.size());
    glm::dvec3 sum(0.0);
    for (int order = 1; order <= orders; ++order) {
        sum += irradiance(order, muS);
    }
    if (closed) {
        const glm::dvec3 last = irradiance(orders, muS);
        const glm::dvec3 before = irradiance(orders - 1, muS);
        for (int c = 0; c < 3; ++c) {
            const double ratio =
                before[c] > 0.0 ? std::min(last[c] / before[c], kLargestRatio) : 0.0;
            sum[c] += last[c] * ratio / (1.0 - ratio);
        }
    }
    return sum;
}

std::array<double, 6> SkySources::at(const Grid& grid, double height, double muS,
                                     double zenithAngle, double azimuthAngle) const {
    const std::size_t size = directionSize();
    const auto suns = std::size_t(sizes_.suns);
    const auto azimuths = std::size_t(sizes_.azimuths);
    const CubicWeights row = cubicWeights(
        (sizes_.heights - 1) * std::sqrt(height / table_->atmosphere().topMetres), sizes_.heights);
    const CubicWeights sun = cubicWeights(sunPlace(muS), sizes_.suns);
    const CubicWeights zenith =
        cubicWeights((sizes_.zenithAngles - 1) * zenithAngle / kPi, sizes_.zenithAngles);
    const CubicWeights azimuth =
        cubicWeights((sizes_.azimuths - 1) * azimuthAngle / kPi, sizes_.azimuths);
    // Four azimuths lie together.
    std::array<float, 24> sums{};
    for (std::size_t h = 0; h < 4; ++h) {
        for (std::size_t s = 0; s < 4; ++s) {
            const float* const cell =
                &grid[((std::size_t(row.first) + h) * suns + std::size_t(sun.first) + s) * size +
                      (std::size_t(zenith.first) * azimuths + std::size_t(azimuth.first)) * 6];
            for (std::size_t z = 0; z < 4; ++z) {
                const auto weight = float(row.weights[h] * sun.weights[s] * zenith.weights[z]);
                const float* const four = cell + z * azimuths * 6;
                for (std::size_t k = 0; k < sums.size(); ++k) {
                    sums[k] += weight * four[k];
                }
            }
        }
    }
    std::array<double, 6> source{};
    for (std::size_t k = 0; k < sums.size(); ++k) {
        source[k % 6] += azimuth.weights[k / 6] * double(sums[k]);
    }
    return source;
}

glm::dvec3 SkySources::march(const Grid& grid, const AirPath& path,
                             const std::vector<PathNode>& nodes) const {
    const shader::Air air = airOf(table_->atmosphere());
    glm::dvec3 light(0.0);
    for (const PathNode& node : nodes) {
        const double mu = shader::cosineAlong(air, path.height, path.mu, node.t, node.height);
        const double muS =
            shader::sunCosineAlong(air, path.height, path.muS, path.nu, node.t, node.height);
        const double sines = std::sqrt((1.0 - mu * mu) * (1.0 - muS * muS));
        const double cosAzimuth =
            sines > 1e-12 ? std::clamp((path.nu - mu * muS) / sines, -1.0, 1.0) : 1.0;
        const std::array<double, 6> source =
            at(grid, node.height, muS, std::acos(mu), std::acos(cosAzimuth));
        light += node.rayleigh * glm::dvec3(source[0], source[1], source[2]) +
                 node.mie * glm::dvec3(source[3], source[4], source[5]);
    }
    return glm::max(light, glm::dvec3(0.0));
}

SkySources::Grid SkySources::sum(bool closed) const {
    const std::size_t orders = tables_.grids.size();
    CHECK(!closed || orders >= 3);
    Grid sum = tables_.grids.front();
    for (std::size_t order = 1; order < orders; ++order) {
        for (std::size_t i = 0; i < sum.size(); ++i) {
            sum[i] += tables_.grids[order][i];
        }
    }
    const std::size_t size = directionSize();
    for (std::size_t cell = 0; closed && cell < sum.size(); cell += size) {
        for (std::size_t colour = 0; colour < 6; ++colour) {
            double last = 0.0;
            double before = 0.0;
            for (std::size_t i = cell + colour; i < cell + size; i += 6) {
                last += double(tables_.grids[orders - 1][i]);
                before += double(tables_.grids[orders - 2][i]);
            }
            const double ratio = before > 0.0 ? std::min(last / before, kLargestRatio) : 0.0;
            for (std::size_t i = cell + colour; i < cell + size; i += 6) {
                sum[i] += float(ratio / (1.0 - ratio)) * tables_.grids[orders - 1][i];
            }
        }
    }
    return sum;
}

glm::dvec3 SkySources::along(const AirPath& path, int order) const {
    CHECK(order >= 2 && order < 2 + int(tables_.grids.size()));
    const glm::dvec2 range = sunsOver(airOf(table_->atmosphere()), path);
    const std::vector<bool>& wanted = wanted_[std::size_t(order - 2)];
    CHECK(wanted[std::size_t(cubicWeights(sunPlace(range.x), sizes_.suns).first)] &&
          wanted[std::size_t(cubicWeights(sunPlace(range.y), sizes_.suns).first) + 3]);
    std::vector<PathNode> nodes;
    for (const PathPiece& piece : piecesOf(table_->atmosphere(), path)) {
        addNodes(*table_, path, piece, alongFirst_, nodes);
    }
    return march(tables_.grids[std::size_t(order - 2)], path, nodes);
}

}  // namespace ribalta
