#include "reference/sky_sight.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "base/check.h"
#include "base/parallel_for.h"
#include "reference/integrate_sky.h"
#include "sky/sky_air.h"
#include "sky/sky_eye.h"
#include "sky/sky_sources.h"

namespace ribalta {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kOrdersOfAll = 10;
constexpr int kNodesOfFirst = 32;  // of each piece of a ray: 2e-6 (95 % of rays)
constexpr int kNodesOfLater = 16;

/// Limb darkening: the disc's radiance is that of its middle times cos^kLimb (after Hestroffer &
/// Magnan 1998 at 680, 550, 440 nm).
const glm::dvec3 kLimb(0.42, 0.52, 0.68);

}  // namespace

class SkySight::Impl {
  public:
    explicit Impl(const SkyOverScene& sky)
        : sky_(sky),
          orders_(sky.orders.closed && sky.orders.count >= 4 ? kOrdersOfAll : sky.orders.count),
          lengths_(checked(sky.air)),
          first_(gaussRule(kNodesOfFirst)),
          later_(gaussRule(kNodesOfLater)) {
        CHECK(orders_ >= 1 && orders_ <= kMostTabulatedOrders);
        if (orders_ > 1) {
            sources_.emplace(lengths_, orders_, true, coarseSkyTables());
            sum_ = sources_->sum(false);
        }
    }

    const SkyOverScene& sky() const { return sky_; }
    int orders() const { return orders_; }
    const OpticalLengthTable& lengths() const { return lengths_; }

    SkyLight along(const AirPath& path) const;
    glm::dvec3 single(const AirPath& path) const;
    glm::dvec3 later(const SkySources& sources, const SkySources::Grid& sum,
                     const AirPath& path) const;
    glm::dvec3 later(const AirPath& path) const {
        return sources_ ? later(*sources_, sum_, path) : glm::dvec3(0.0);
    }
    glm::dvec3 sunDisc(const glm::dvec3& direction, double pixelRadians) const;

  private:
    glm::dvec3 groundIrradiance(double muS) const;

    SkyOverScene sky_;
    int orders_;
    OpticalLengthTable lengths_;
    GaussRule first_;
    GaussRule later_;
    std::optional<SkySources> sources_;
    SkySources::Grid sum_;
};

glm::dvec3 SkySight::Impl::single(const AirPath& path) const {
    const shader::Air air = airOf(sky_.air);
    std::vector<PathNode> nodes;
    for (const PathPiece& piece : piecesOf(sky_.air, path)) {
        if (piece.lit) {
            addNodes(lengths_, path, piece, first_, nodes);
        }
    }
    glm::dvec3 rayleigh(0.0);
    glm::dvec3 mie(0.0);
    for (const PathNode& node : nodes) {
        const double muS =
            shader::sunCosineAlong(air, path.height, path.muS, path.nu, node.t, node.height);
        const glm::dvec3 sun = transmittance(sky_.air, lengths_.toTop(node.height, muS));
        rayleigh += node.rayleigh * sun;
        mie += node.mie * sun;
    }
    return shader::phaseRayleigh(path.nu) * rayleigh +
           shader::phaseCornetteShanks(path.nu, air.mieG) * mie;
}

glm::dvec3 SkySight::Impl::later(const SkySources& sources, const SkySources::Grid& sum,
                                 const AirPath& path) const {
    std::vector<PathNode> nodes;
    for (const PathPiece& piece : piecesOf(sky_.air, path)) {
        addNodes(lengths_, path, piece, later_, nodes);
    }
    return sources.march(sum, path, nodes);
}

// By light that the ground may still reflect: all orders but the last.
glm::dvec3 SkySight::Impl::groundIrradiance(double muS) const {
    glm::dvec3 sum = sunIrradiance(lengths_, muS);
    for (int order = 1; order < orders_; ++order) {
        sum += sources_->irradiance(order, muS);
    }
    return sum;
}

SkyLight SkySight::Impl::along(const AirPath& path) const {
    SkyLight light;
    light.transmittance =
        transmittance(sky_.air, opticalLengths(sky_.air, path.height, path.mu, path.length));
    light.air = single(path) + later(path);
    if (path.endsOnGround) {
        light.ground =
            groundLight(lengths_, path, [&](double muS) { return groundIrradiance(muS); });
    }
    return light;
}

glm::dvec3 SkySight::Impl::sunDisc(const glm::dvec3& direction, double pixelRadians) const {
    const double radius = sky_.air.sunAngularRadius;
    const double angle =
        2.0 * std::asin(std::min(0.5 * glm::length(direction - sky_.towardsSun), 1.0));
    const double covered =
        std::clamp((radius - angle) / std::max(pixelRadians, 1e-9) + 0.5, 0.0, 1.0);
    if (covered <= 0.0 || radius <= 0.0) {
        return glm::dvec3(0.0);
    }
    const double across = std::min(angle / radius, 0.999);
    const glm::dvec3 limb =
        glm::pow(glm::dvec3(std::sqrt(1.0 - across * across)), kLimb) * (0.5 * kLimb + 1.0);
    return covered * limb / (2.0 * kPi * (1.0 - std::cos(radius)));
}

SkySight::SkySight(const SkyOverScene& sky) : impl_(std::make_unique<const Impl>(sky)) {}
SkySight::~SkySight() = default;
SkySight::SkySight(SkySight&&) noexcept = default;
SkySight& SkySight::operator=(SkySight&&) noexcept = default;

const SkyOverScene& SkySight::sky() const {
    return impl_->sky();
}

SkyRay SkySight::ray(const glm::dvec3& from, const glm::dvec3& direction) const {
    const SkyOverScene& sky = impl_->sky();
    const SkyEye eye = skyEye(sky.air, sky.altitudeMetres, sky.towardsSun, from);
    return {eye.heightMetres, glm::dot(direction, eye.zenith), eye.muS,
            glm::dot(direction, sky.towardsSun)};
}

SkyLight SkySight::along(const SkyRay& ray) const {
    const std::optional<AirPath> path = airPath(impl_->sky().air, ray);
    return path ? impl_->along(*path) : SkyLight();
}

glm::dvec3 SkySight::behind(const glm::dvec3& from, const glm::dvec3& direction,
                            double pixelRadians) const {
    const std::optional<AirPath> path = airPath(impl_->sky().air, ray(from, direction));
    const SkyLight light = path ? impl_->along(*path) : SkyLight();
    glm::dvec3 sum = light.air + light.ground;
    if (!path || !path->ground) {
        sum += impl_->sunDisc(direction, pixelRadians) * light.transmittance;
    }
    return sum * impl_->sky().air.sunIlluminanceLux;
}

glm::dvec3 SkySight::throughAir(const glm::dvec3& color, const glm::dvec3& from,
                                const glm::dvec3& direction, double metres) const {
    SkyRay before = ray(from, direction);
    before.distanceMetres = metres;
    const SkyLight light = along(before);
    return color * light.transmittance + light.air * impl_->sky().air.sunIlluminanceLux;
}

SkyError SkySight::errorOf(std::span<const SkyRay> rays) const {
    const Atmosphere& air = impl_->sky().air;
    const SkyIntegrator exact(air, {.orders = 1}, {});
    std::optional<SkySources> coarse;
    SkySources::Grid coarseSum;
    if (impl_->orders() > 1) {
        coarse.emplace(impl_->lengths(), impl_->orders(), true, pictureSkyTables());
        coarseSum = coarse->sum(false);
    }
    std::vector<double> errors(rays.size());
    parallelFor(rays.size(), [&](std::size_t i) {
        const std::optional<AirPath> path = airPath(air, rays[i]);
        if (!path) {
            return;
        }
        const glm::dvec3 first = impl_->single(*path);
        const glm::dvec3 later = impl_->later(*path);
        glm::dvec3 off = glm::abs(first - exact.singleAlong(rays[i]).sum());
        if (coarse) {
            off += glm::abs(later - impl_->later(*coarse, coarseSum, *path));
        }
        const glm::dvec3 sum = first + later;
        const double largest = std::max({sum.x, sum.y, sum.z});
        errors[i] = largest > 0.0 ? std::max({off.x, off.y, off.z}) / largest : 0.0;
    });
    SkyError error;
    for (const double each : errors) {
        error.largest = std::max(error.largest, each);
        error.rms += each * each / double(errors.size());
    }
    error.rms = std::sqrt(error.rms);
    return error;
}

}  // namespace ribalta
