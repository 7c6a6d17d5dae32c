// Order 1 by adaptive quadrature with exact optical lengths, order 2 by quadrature over all
// directions of order 1, the rest from SkySources.
#include "reference/integrate_sky.h"

#include <array>
#include <cmath>

#include "base/adaptive_integral.h"
#include "base/check.h"
#include "sky/optical_length.h"
#include "sky/sky_air.h"
#include "sky/sky_field.h"

namespace ribalta {
namespace {

// For order 2: far more than SkySources takes, as there is nothing to be interpolated after it.
constexpr DirectionCounts kDirections{40, 28, 49};
constexpr int kNodesOfPiece = 24;

std::vector<AirPath> pathsOf(const Atmosphere& atmosphere, std::span<const SkyRay> rays) {
    std::vector<AirPath> paths;
    for (const SkyRay& ray : rays) {
        if (const std::optional<AirPath> path = airPath(atmosphere, ray)) {
            paths.push_back(*path);
        }
    }
    return paths;
}

}  // namespace

class SkyIntegrator::Impl {
  public:
    Impl(const Atmosphere& atmosphere, const SkySettings& settings, std::span<const SkyRay> rays)
        : atmosphere_(checked(atmosphere)),
          settings_(settings),
          table_(atmosphere_),
          rule_(gaussRule(kNodesOfPiece)) {
        CHECK(settings.orders >= 1 && settings.orders <= kMostSkyOrders);
        if (settings.orders >= (settings.exactSecondOrder ? 3 : 2)) {
            sources_.emplace(table_, settings.orders, settings.groundLightsAir, settings.tables,
                             pathsOf(atmosphere_, rays));
        }
    }

    const Atmosphere& atmosphere() const { return atmosphere_; }
    int orders() const { return settings_.orders; }

    SingleScattering single(const AirPath& path) const;
    glm::dvec3 order(const AirPath& path, int order) const;
    glm::dvec3 irradiance(int order, double muS) const;
    glm::dvec3 ground(const AirPath& path) const;

  private:
    glm::dvec3 second(const AirPath& path) const;
    glm::dvec3 exactSun(double height, double muS) const;
    void addReflectedSun(double height, double muS, const SkyDirections& directions,
                         std::vector<glm::dvec3>& field) const;

    Atmosphere atmosphere_;
    SkySettings settings_;
    OpticalLengthTable table_;
    GaussRule rule_;
    std::optional<SkySources> sources_;
};

glm::dvec3 SkyIntegrator::Impl::exactSun(double height, double muS) const {
    const shader::Air air = airOf(atmosphere_);
    if (shader::hitsGround(air, height, muS)) {
        return glm::dvec3(0.0);
    }
    return transmittance(atmosphere_, opticalLengths(atmosphere_, height, muS,
                                                     shader::distanceToTop(air, height, muS)));
}

SingleScattering SkyIntegrator::Impl::single(const AirPath& path) const {
    constexpr double kRelative = 1e-7;  // of the weaker of two rules
    const shader::Air air = airOf(atmosphere_);
    const auto light = [&](double t) -> std::array<double, 6> {
        const double height =
            std::clamp(shader::heightAlong(air, path.height, path.mu, t), 0.0, air.top);
        const double muS = shader::sunCosineAlong(air, path.height, path.muS, path.nu, t, height);
        const glm::dvec3 reaching =
            exactSun(height, muS) *
            transmittance(atmosphere_, opticalLengths(atmosphere_, path.height, path.mu, t));
        const glm::dvec3 rayleigh =
            shader::airDensity(height, air.rayleighHeight) * air.rayleighScattering * reaching;
        const glm::dvec3 mie =
            shader::airDensity(height, air.mieHeight) * air.mieScattering * reaching;
        return {rayleigh.x, rayleigh.y, rayleigh.z, mie.x, mie.y, mie.z};
    };
    std::array<double, 6> sum{};
    for (const PathPiece& piece : piecesOf(atmosphere_, path)) {
        if (!piece.lit) {
            continue;
        }
        // Short where the air is dense.
        std::array<double, 5> cuts{};
        for (std::size_t i = 0; i < cuts.size(); ++i) {
            const double u = double(i) / 4.0;
            const double part = piece.risesFromFirst ? u * u : 1.0 - (1.0 - u) * (1.0 - u);
            cuts[i] = piece.first + part * (piece.last - piece.first);
        }
        const std::array<double, 6> part = integrateAdaptively<6>(light, cuts, kRelative);
        for (std::size_t c = 0; c < sum.size(); ++c) {
            sum[c] += part[c];
        }
    }
    return {shader::phaseRayleigh(path.nu) * glm::dvec3(sum[0], sum[1], sum[2]),
            shader::phaseCornetteShanks(path.nu, air.mieG) * glm::dvec3(sum[3], sum[4], sum[5])};
}

void SkyIntegrator::Impl::addReflectedSun(double height, double muS,
                                          const SkyDirections& directions,
                                          std::vector<glm::dvec3>& field) const {
    const std::size_t turns = directions.cosAzimuths.size();
    for (std::size_t i = 0; i < field.size(); ++i) {
        const AirPath path = airPathTowards(atmosphere_, height, directions.mu[i / turns], muS,
                                            directions.cosAzimuths[i % turns]);
        if (path.endsOnGround) {
            field[i] += groundLight(table_, path,
                                    [&](double there) { return sunIrradiance(table_, there); });
        }
    }
}

glm::dvec3 SkyIntegrator::Impl::second(const AirPath& path) const {
    const shader::Air air = airOf(atmosphere_);
    std::vector<PathNode> nodes;
    for (const PathPiece& piece : piecesOf(atmosphere_, path)) {
        addNodes(table_, path, piece, rule_, nodes);
    }
    glm::dvec3 light(0.0);
    for (const PathNode& node : nodes) {
        const double mu = shader::cosineAlong(air, path.height, path.mu, node.t, node.height);
        const double muS =
            shader::sunCosineAlong(air, path.height, path.muS, path.nu, node.t, node.height);
        const double sine = std::sqrt(1.0 - mu * mu);
        const double sines = sine * std::sqrt(1.0 - muS * muS);
        const double azimuth =
            sines > 1e-12 ? std::acos(std::clamp((path.nu - mu * muS) / sines, -1.0, 1.0)) : 0.0;
        const SkyDirections directions = directionsAt(atmosphere_, node.height, kDirections);
        std::vector<glm::dvec3> field =
            firstOrderField(table_, node.height, muS, directions, rule_);
        if (settings_.groundLightsAir) {
            addReflectedSun(node.height, muS, directions, field);
        }
        const std::size_t turns = directions.cosAzimuths.size();
        for (std::size_t i = 0; i < field.size(); ++i) {
            const double from = directions.mu[i / turns];
            const double product = mu * from;
            const double across = sine * std::sqrt(1.0 - from * from);
            const double turn = std::acos(directions.cosAzimuths[i % turns]);
            // Half of the light comes from each side of the sun.
            const double left = product + across * std::cos(turn - azimuth);
            const double right = product + across * std::cos(turn + azimuth);
            const double weight =
                0.5 * directions.weights[i / turns] * directions.azimuthWeights[i % turns];
            light += weight * field[i] *
                     ((shader::phaseRayleigh(left) + shader::phaseRayleigh(right)) * node.rayleigh +
                      (shader::phaseCornetteShanks(left, air.mieG) +
                       shader::phaseCornetteShanks(right, air.mieG)) *
                          node.mie);
        }
    }
    return light;
}

glm::dvec3 SkyIntegrator::Impl::order(const AirPath& path, int order) const {
    CHECK(order >= 1 && order <= settings_.orders);
    if (order == 1) {
        return single(path).sum();
    }
    return order == 2 && settings_.exactSecondOrder ? second(path) : sources_->along(path, order);
}

glm::dvec3 SkyIntegrator::Impl::irradiance(int order, double muS) const {
    CHECK(order >= 0 && order < settings_.orders);
    if (order == 0) {
        return std::max(muS, 0.0) * exactSun(0.0, muS);
    }
    if (order == 1) {
        const SkyDirections directions = directionsAt(atmosphere_, 0.0, kDirections);
        return irradianceOf(directions, firstOrderField(table_, 0.0, muS, directions, rule_));
    }
    return sources_->irradiance(order, muS);
}

glm::dvec3 SkyIntegrator::Impl::ground(const AirPath& path) const {
    if (!path.endsOnGround) {
        return glm::dvec3(0.0);
    }
    return groundLight(table_, path, [&](double muS) {
        glm::dvec3 sum(0.0);
        for (int order = 0; order < settings_.orders; ++order) {
            sum += irradiance(order, muS);
        }
        return sum;
    });
}

SkyIntegrator::SkyIntegrator(const Atmosphere& atmosphere, const SkySettings& settings,
                             std::span<const SkyRay> rays)
    : impl_(std::make_unique<Impl>(atmosphere, settings, rays)) {}
SkyIntegrator::~SkyIntegrator() = default;
SkyIntegrator::SkyIntegrator(SkyIntegrator&&) noexcept = default;
SkyIntegrator& SkyIntegrator::operator=(SkyIntegrator&&) noexcept = default;

SkyLight SkyIntegrator::along(const SkyRay& ray) const {
    SkyLight light;
    light.transmittance = transmittanceAlong(ray);
    if (const std::optional<AirPath> path = airPath(impl_->atmosphere(), ray)) {
        for (int order = 1; order <= impl_->orders(); ++order) {
            light.air += impl_->order(*path, order);
        }
        light.ground = impl_->ground(*path);
    }
    return light;
}

glm::dvec3 SkyIntegrator::transmittanceAlong(const SkyRay& ray) const {
    const std::optional<AirPath> path = airPath(impl_->atmosphere(), ray);
    return path ? transmittance(
                      impl_->atmosphere(),
                      opticalLengths(impl_->atmosphere(), path->height, path->mu, path->length))
                : glm::dvec3(1.0);
}

SingleScattering SkyIntegrator::singleAlong(const SkyRay& ray) const {
    const std::optional<AirPath> path = airPath(impl_->atmosphere(), ray);
    return path ? impl_->single(*path) : SingleScattering{};
}

glm::dvec3 SkyIntegrator::orderAlong(const SkyRay& ray, int order) const {
    const std::optional<AirPath> path = airPath(impl_->atmosphere(), ray);
    return path ? impl_->order(*path, order) : glm::dvec3(0.0);
}

glm::dvec3 SkyIntegrator::irradiance(int order, double muS) const {
    return impl_->irradiance(order, muS);
}

}  // namespace ribalta
