// SkySight: the sky of a reference picture: what a ray from a place in a scene sees of it, and what
// it does to the light of surfaces, in double precision. Light scattered once is integrated along
// each ray; later orders come from tables finer than a renderer's. Knows no pictures.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "scene/atmosphere.h"
#include "sky/sky_ray.h"
#include "sky/sky_tables.h"

namespace ribalta {

/// A sky over a scene.
struct SkyOverScene {
    Atmosphere air;
    SkyOrders orders;                      ///< closed: ten orders, beyond which there is 1e-4
    glm::dvec3 towardsSun{0.0, 1.0, 0.0};  ///< unit, world
    double altitudeMetres = 0.0;           ///< of the scene's origin above the ground, >= 0
    int sunLamp = -1;  ///< into Scene::directionalLights: the lamp that the sun takes the place of
};

/// Relative, of a ray's largest channel: over rays the largest, and the root of the mean square.
struct SkyError {
    double largest = 0.0;
    double rms = 0.0;
};

/// What the air scatters of light that was scattered before, for all heights, suns and directions:
/// of one air and its orders, wherever the sun stands.
class SkyLightTables;

/// Keeps tables that several pictures share. Not to be asked by two threads at once.
class SkyTableStore {
  public:
    /// Made on all cores (seconds where there is more than one order) unless they are there.
    std::shared_ptr<const SkyLightTables> tablesOf(const Atmosphere& air, const SkyOrders& orders);

  private:
    struct Kept {
        Atmosphere air;
        SkyOrders orders;
        std::shared_ptr<const SkyLightTables> tables;
    };
    std::vector<Kept> kept_;
};

class SkySight {
  public:
    /// `sky.air` as checked() takes it. With tables of its own, or out of a store.
    explicit SkySight(const SkyOverScene& sky, SkyTableStore* store = nullptr);
    ~SkySight();
    SkySight(SkySight&&) noexcept;
    SkySight& operator=(SkySight&&) noexcept;

    /// A view ray as the air takes it; `direction` is unit.
    SkyRay ray(const glm::dvec3& from, const glm::dvec3& direction) const;

    /// For a sun of irradiance 1, for any ray.
    SkyLight along(const SkyRay& ray) const;

    /// cd/m2 of sky, planet's ground and the sun's disc, whose edge is as wide as a pixel of
    /// `pixelRadians`.
    glm::dvec3 behind(const glm::dvec3& from, const glm::dvec3& direction,
                      double pixelRadians) const;
    /// What cd/m2 that come from `metres` away are with the air before them.
    glm::dvec3 throughAir(const glm::dvec3& color, const glm::dvec3& from,
                          const glm::dvec3& direction, double metres) const;

    /// Of along(): order 1 against adaptive quadrature, later ones, conservatively, against tables
    /// a tenth as fine.
    SkyError errorOf(std::span<const SkyRay> rays) const;

    const SkyOverScene& sky() const;

  private:
    class Impl;
    std::unique_ptr<const Impl> impl_;
};

}  // namespace ribalta
