// The sky's answer in double precision: what light a ray through a planet's air brings, by
// integration of the model itself (Bruneton & Neyret 2008). Knows neither pictures nor tables of
// the renderer. The sun is a point whose light outside the air has an irradiance of 1 a channel.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include <glm/glm.hpp>

#include "scene/atmosphere.h"
#include "sky/sky_ray.h"
#include "sky/sky_sources.h"

namespace ribalta {

struct SkySettings {
    /// How often light may have been scattered or reflected, 1..kMostSkyOrders.
    int orders = 4;
    /// Whether the air is lit by light that the ground reflected. Without, the ground is only seen
    /// by rays that end on it.
    bool groundLightsAir = true;
    /// Order 2 by quadrature for each ray (a quarter of a second); otherwise from the tables too.
    bool exactSecondOrder = true;
    SkyTableSizes tables = {};
};
inline constexpr int kMostSkyOrders = 20;

/// Light once scattered, by what scattered it; per irradiance of the sun, 1/sr.
struct SingleScattering {
    glm::dvec3 rayleigh{0.0};
    glm::dvec3 mie{0.0};
    glm::dvec3 sum() const { return rayleigh + mie; }
};

/// Exact but slow: order 1 adaptively, order 2 by quadrature of high degree over the whole sphere
/// of directions, higher orders by tables of what is scattered at each height under each sun.
class SkyIntegrator {
  public:
    /// `atmosphere` as checked() takes it. Where there are orders to tabulate, makes the
    /// tables that `rays` need, on all cores (seconds to minutes); along() then takes no others.
    SkyIntegrator(const Atmosphere& atmosphere, const SkySettings& settings,
                  std::span<const SkyRay> rays);
    ~SkyIntegrator();
    SkyIntegrator(SkyIntegrator&&) noexcept;
    SkyIntegrator& operator=(SkyIntegrator&&) noexcept;

    SkyLight along(const SkyRay& ray) const;

    /// Of the part of the ray within the air, per channel; 1 where it passes by. Good to 1e-11.
    glm::dvec3 transmittanceAlong(const SkyRay& ray) const;
    /// Order 1 alone. Good to 1e-9 of itself.
    SingleScattering singleAlong(const SkyRay& ray) const;
    /// One order of 2..orders alone.
    glm::dvec3 orderAlong(const SkyRay& ray, int order) const;
    /// On the ground under a sun of cosine muS: order 0 is the sun itself, up to orders - 1.
    glm::dvec3 irradiance(int order, double muS) const;

  private:
    class Impl;
    std::unique_ptr<const Impl> impl_;
};

}  // namespace ribalta
