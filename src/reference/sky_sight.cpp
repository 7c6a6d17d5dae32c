#include "reference/sky_sight.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "base/check.h"
#include "base/parallel_for.h"
#include "reference/integrate_sky.h"
#include "sky/sky_air.h"
#include "sky/sky_eye.h"
#include "sky/sky_sources.h"

namespace ribalta {
namespace {

constexpr int kOrdersOfAll = 10;
constexpr int kNodesOfFirst = 32;  // of each piece of a ray: 2e-6 (95 % of rays)
constexpr int kNodesOfLater = 16;

}  // namespace

class SkyLightTables {
  public:
    /// Sources of all orders but the first, and all of them in one.
    struct Later {
        SkySources sources;
        SkySources::Grid sum;

        Later(const OpticalLengthTable& lengths, int orders, const SkyTableSizes& sizes)
            : sources(lengths, orders, true, sizes), sum(sources.sum(false)) {}
    };

    SkyLightTables(const Atmosphere& air, const SkyOrders& skyOrders)
        : orders(skyOrders.closed && skyOrders.count >= 4 ? kOrdersOfAll : skyOrders.count),
          lengths(checked(air)) {
        CHECK(orders >= 1 && orders <= kMostTabulatedOrders);
        if (orders > 1) {
            later.emplace(lengths, orders, coarseSkyTables());
            coarser.emplace(lengths, orders, pictureSkyTables());
        }
    }
    SkyLightTables(const SkyLightTables&) = delete;  // the sources refer to the lengths
    SkyLightTables& operator=(const SkyLightTables&) = delete;

    const int orders;
    const OpticalLengthTable lengths;
    std::optional<Later> later;
    std::optional<Later> coarser;  ///< tells how far the others may be off
};

std::shared_ptr<const SkyLightTables> SkyTableStore::tablesOf(const Atmosphere& air,
                                                              const SkyOrders& orders) {
    for (const Kept& kept : kept_) {
        if (kept.air == air && kept.orders == orders) {
            return kept.tables;
        }
    }
    kept_.push_back({air, orders, std::make_shared<const SkyLightTables>(air, orders)});
    return kept_.back().tables;
}

class SkySight::Impl {
  public:
    Impl(const SkyOverScene& sky, std::shared_ptr<const SkyLightTables> tables)
        : sky_(sky),
          tables_(std::move(tables)),
          lengths_(tables_->lengths),
          first_(gaussRule(kNodesOfFirst)),
          later_(gaussRule(kNodesOfLater)) {}

    const SkyOverScene& sky() const { return sky_; }
    const SkyLightTables& tables() const { return *tables_; }

    SkyLight along(const AirPath& path) const;
    glm::dvec3 single(const AirPath& path) const;
    glm::dvec3 later(const std::optional<SkyLightTables::Later>& tables, const AirPath& path) const;

  private:
    glm::dvec3 groundIrradiance(double muS) const;

    SkyOverScene sky_;
    std::shared_ptr<const SkyLightTables> tables_;
    const OpticalLengthTable& lengths_;
    GaussRule first_;
    GaussRule later_;
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

glm::dvec3 SkySight::Impl::later(const std::optional<SkyLightTables::Later>& tables,
                                 const AirPath& path) const {
    if (!tables) {
        return glm::dvec3(0.0);
    }
    std::vector<PathNode> nodes;
    for (const PathPiece& piece : piecesOf(sky_.air, path)) {
        addNodes(lengths_, path, piece, later_, nodes);
    }
    return tables->sources.march(tables->sum, path, nodes);
}

glm::dvec3 SkySight::Impl::groundIrradiance(double muS) const {
    const glm::dvec3 sun = sunIrradiance(lengths_, muS);
    return tables_->later ? sun + tables_->later->sources.irradianceOfAll(false, muS) : sun;
}

SkyLight SkySight::Impl::along(const AirPath& path) const {
    SkyLight light;
    light.transmittance =
        transmittance(sky_.air, opticalLengths(sky_.air, path.height, path.mu, path.length));
    light.air = single(path) + later(tables_->later, path);
    if (path.endsOnGround) {
        light.ground =
            groundLight(lengths_, path, [&](double muS) { return groundIrradiance(muS); });
    }
    return light;
}

SkySight::SkySight(const SkyOverScene& sky, SkyTableStore* store) {
    SkyTableStore own;
    impl_ = std::make_unique<const Impl>(
        sky, (store != nullptr ? *store : own).tablesOf(sky.air, sky.orders));
}
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
        const SkyOverScene& sky = impl_->sky();
        sum += light.transmittance * shader::sunDisc(direction, sky.towardsSun,
                                                     sky.air.sunAngularRadius,
                                                     std::max(pixelRadians, 1e-9));
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
    std::vector<double> errors(rays.size());
    parallelFor(rays.size(), [&](std::size_t i) {
        const std::optional<AirPath> path = airPath(air, rays[i]);
        if (!path) {
            return;
        }
        const glm::dvec3 first = impl_->single(*path);
        const glm::dvec3 later = impl_->later(impl_->tables().later, *path);
        glm::dvec3 off = glm::abs(first - exact.singleAlong(rays[i]).sum());
        off += glm::abs(later - impl_->later(impl_->tables().coarser, *path));
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
