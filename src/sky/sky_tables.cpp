// The sky's tables by the reference's own parts, only coarser.
#include "sky/sky_tables.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/angles.h"
#include "base/check.h"
#include "base/parallel_for.h"
#include "sky/obtain_sky_sources.h"
#include "sky/sky_air.h"
#include "sky/sky_sources.h"

namespace ribalta {
namespace {

constexpr DirectionCounts kAround{16, 10, 17};  // of the light that falls on surfaces

glm::vec4 logOf(const double* colours) {
    glm::vec4 result(0.0F);
    for (int c = 0; c < 3; ++c) {
        result[c] = float(std::log(std::max(colours[c], double(shader::kDarkest))));
    }
    return result;
}

/// 0..1: how much of a disc lies above a line; both as angles, `above` from the line to its centre.
double discAbove(double above, double radius) {
    if (radius <= 0.0) {
        return above >= 0.0 ? 1.0 : 0.0;
    }
    const double x = std::clamp(above / radius, -1.0, 1.0);
    return 0.5 + (x * std::sqrt(1.0 - x * x) + std::asin(x)) / kPi;
}

}  // namespace

class SkyTables::Impl {
  public:
    Impl(const Atmosphere& atmosphere, const SkyOrders& orders, const FileCache* files)
        : air_(checked(atmosphere)),
          orders_(orders),
          lengths_(air_, shader::kLengthHeights, shader::kLengthCosines),
          rule_(gaussRule(12)) {
        CHECK(orders.count >= 1 && orders.count <= kMostTabulatedOrders);
        if (orders_.count >= 2) {
            sources_.emplace(obtainSkySources(lengths_, orders_.count, pictureSkyTables(), files));
            sum_ = sources_->sum(closed());
        }
    }

    const Atmosphere& air() const { return air_; }
    const OpticalLengthTable& lengths() const { return lengths_; }
    const std::optional<SkySources>& sources() const { return sources_; }
    const SkySources::Grid& sum() const { return sum_; }

    /// By the sky alone.
    glm::dvec3 groundIrradiance(double muS) const;
    std::vector<glm::dvec3> light(double height, double muS, const SkyDirections& directions) const;

  private:
    bool closed() const { return orders_.closed && orders_.count >= 4; }

    Atmosphere air_;
    SkyOrders orders_;
    OpticalLengthTable lengths_;
    GaussRule rule_;
    std::optional<SkySources> sources_;
    SkySources::Grid sum_;
};

glm::dvec3 SkyTables::Impl::groundIrradiance(double muS) const {
    return sources_ ? sources_->irradianceOfAll(closed(), muS) : glm::dvec3(0.0);
}

std::vector<glm::dvec3> SkyTables::Impl::light(double height, double muS,
                                               const SkyDirections& directions) const {
    std::vector<glm::dvec3> field = firstOrderField(lengths_, height, muS, directions, rule_);
    const std::size_t turns = directions.cosAzimuths.size();
    parallelFor(directions.mu.size(), [&](std::size_t i) {
        for (std::size_t j = 0; j < turns; ++j) {
            const AirPath path =
                airPathTowards(air_, height, directions.mu[i], muS, directions.cosAzimuths[j]);
            glm::dvec3& sum = field[i * turns + j];
            if (sources_) {
                std::vector<PathNode> nodes;
                for (const PathPiece& piece : piecesOf(air_, path)) {
                    addNodes(lengths_, path, piece, rule_, nodes);
                }
                sum += sources_->march(sum_, path, nodes);
            }
            if (path.endsOnGround) {
                sum += groundLight(lengths_, path, [&](double there) {
                    return sunIrradiance(lengths_, there) + groundIrradiance(there);
                });
            }
        }
    });
    return field;
}

SkyTables::SkyTables(const Atmosphere& atmosphere, const SkyOrders& orders, const FileCache* files)
    : impl_(std::make_unique<const Impl>(atmosphere, orders, files)) {
    if (!impl_->sources()) {
        return;
    }
    const SkySources& sources = *impl_->sources();
    const std::size_t suns = shader::kSourceSuns;
    const std::size_t rows = shader::kSourceZeniths;
    const std::size_t azimuths = shader::kSourceAzimuths;
    const std::size_t layers = shader::kSourceHeights * azimuths;
    rayleigh_.resize(layers * rows * suns);
    mie_.resize(rayleigh_.size());
    const auto cosineOf = [&](std::size_t sun) {
        const double y = sources.firstSun() +
                         (sources.lastSun() - sources.firstSun()) * double(sun) / double(suns - 1);
        return std::clamp(sources.sunScale() * std::sinh(y), -1.0, 1.0);
    };
    parallelFor(layers, [&](std::size_t layer) {
        const std::size_t row = layer / azimuths;
        const double part = double(row) / (shader::kSourceHeights - 1);
        const double height = impl_->air().topMetres * part * part;
        const double azimuth = kPi * double(layer % azimuths) / double(azimuths - 1);
        for (std::size_t angle = 0; angle < rows; ++angle) {
            const double zenith = kPi * double(angle) / double(rows - 1);
            for (std::size_t sun = 0; sun < suns; ++sun) {
                const std::array<double, 6> source =
                    sources.at(impl_->sum(), height, cosineOf(sun), zenith, azimuth);
                const std::size_t place = (layer * rows + angle) * suns + sun;
                rayleigh_[place] = logOf(source.data());
                mie_[place] = logOf(&source[3]);
            }
        }
    });
    for (std::size_t sun = 0; sun < suns; ++sun) {
        const glm::dvec3 light = impl_->groundIrradiance(cosineOf(sun));
        irradiance_.push_back(logOf(&light.x));
    }
}
SkyTables::~SkyTables() = default;
SkyTables::SkyTables(SkyTables&&) noexcept = default;
SkyTables& SkyTables::operator=(SkyTables&&) noexcept = default;

std::vector<glm::vec4> SkyTables::opticalLengths() const {
    std::vector<glm::vec4> values;
    for (const glm::dvec2& logs : impl_->lengths().logs()) {
        values.emplace_back(glm::max(logs, std::log(double(shader::kDarkest))), 0.0, 0.0);
    }
    return values;
}

glm::dvec3 SkyTables::suns() const {
    const std::optional<SkySources>& sources = impl_->sources();
    return sources ? glm::dvec3(sources->sunScale(), sources->firstSun(), sources->lastSun())
                   : glm::dvec3(1.0, -1.0, 1.0);
}

glm::dvec3 SkyTables::sunlight(double height, double muS) const {
    const shader::Air air = airOf(impl_->air());
    const double radius = air.groundRadius;
    const double horizon =
        -std::atan2(std::sqrt(shader::airSquare(air, std::max(height, 0.0))), radius);
    const double elevation = std::asin(std::clamp(muS, -1.0, 1.0));
    const double sunRadius = impl_->air().sunAngularRadius;
    const double seen = discAbove(elevation - horizon, sunRadius);
    if (seen <= 0.0) {
        return glm::dvec3(0.0);
    }
    // Of a sun that is half set, what is seen stands higher than its centre.
    const double shown = std::max(elevation, horizon + 1e-6);
    if (height >= air.top) {
        const std::optional<AirPath> path =
            airPath(impl_->air(), {height, std::sin(shown), std::sin(shown), 1.0});
        return seen * (path ? transmittance(impl_->air(),
                                            impl_->lengths().along(path->height, path->mu,
                                                                   path->length, path->ground))
                            : glm::dvec3(1.0));
    }
    return seen * transmittance(impl_->air(),
                                impl_->lengths().toTop(std::max(height, 0.0), std::sin(shown)));
}

SkyIrradiance SkyTables::irradianceAt(double height, double muS) const {
    const double within = std::clamp(height, 0.0, impl_->air().topMetres);
    const SkyDirections directions = directionsAt(impl_->air(), within, kAround);
    const std::vector<glm::dvec3> field = impl_->light(within, muS, directions);
    SkyIrradiance sum;
    const std::size_t turns = directions.cosAzimuths.size();
    for (std::size_t i = 0; i < field.size(); ++i) {
        const double mu = directions.mu[i / turns];
        const double sine = std::sqrt(1.0 - mu * mu);
        const double cosine = directions.cosAzimuths[i % turns];
        const double side = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
        const glm::dvec3 light =
            directions.weights[i / turns] * directions.azimuthWeights[i % turns] * field[i];
        sum.up += std::max(mu, 0.0) * light;
        sum.down += std::max(-mu, 0.0) * light;
        sum.towardsSun += std::max(sine * cosine, 0.0) * light;
        sum.awayFromSun += std::max(-sine * cosine, 0.0) * light;
        // Half of the light comes from each side.
        sum.across += 0.5 * sine * side * light;
    }
    return sum;
}

}  // namespace ribalta
