// SkyTables: what a renderer keeps of a planet's sky, for all heights, suns and directions: how
// much air lies on every way, and what the air scatters of light that was scattered before. Light
// scattered once is not in it: it is summed up along each ray. No OpenGL here.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/glm.hpp>

#include "base/file_cache.h"
#include "scene/atmosphere.h"

namespace ribalta {

/// Which light is taken.
struct SkyOrders {
    int count = 4;  ///< how often it may have been scattered or reflected, 1..kMostTabulatedOrders
    bool closed = true;  ///< with count >= 4: the rest of the series too, by its ratio

    bool operator==(const SkyOrders&) const = default;
};
inline constexpr int kMostTabulatedOrders = 20;

/// Light from all around, as what a surface that looks along an axis is lit by: lux a channel, for
/// a sun of irradiance 1.
struct SkyIrradiance {
    glm::dvec3 up{0.0};    ///< looking at the zenith
    glm::dvec3 down{0.0};  ///< lit by the ground
    glm::dvec3 towardsSun{0.0};
    glm::dvec3 awayFromSun{0.0};
    glm::dvec3 across{0.0};  ///< at right angles to both
};

class SkyTables {
  public:
    /// On all cores. `atmosphere` as checked() takes it. One order needs no sources; those of more
    /// are kept in `files`, if any.
    SkyTables(const Atmosphere& atmosphere, const SkyOrders& orders,
              const FileCache* files = nullptr);
    ~SkyTables();
    SkyTables(SkyTables&&) noexcept;
    SkyTables& operator=(SkyTables&&) noexcept;

    /// As shaders/lib/sky_tables.glsl names the places; [row][column].
    std::vector<glm::vec4> opticalLengths() const;
    /// [layer][row][column], layer = height * kSourceAzimuths + azimuth; empty for one order.
    const std::vector<glm::vec4>& rayleighSources() const { return rayleigh_; }
    const std::vector<glm::vec4>& mieSources() const { return mie_; }
    /// Logarithms of what the sky alone sends to level ground, by suns; empty for one order.
    const std::vector<glm::vec4>& groundIrradiance() const { return irradiance_; }
    /// What sourceSun() takes.
    glm::dvec3 suns() const;

    /// The part of the sun's light, per channel, that comes to a height (metres, any): 1 above the
    /// air, 0 where the ground hides the sun's centre by more than its radius; in between by how
    /// much of its disc is seen.
    glm::dvec3 sunlight(double height, double muS) const;
    /// Of sky and ground, not of the sun, for a point at a height (0..top) in free air.
    SkyIrradiance irradianceAt(double height, double muS) const;

  private:
    class Impl;

    std::unique_ptr<const Impl> impl_;
    std::vector<glm::vec4> rayleigh_;
    std::vector<glm::vec4> mie_;
    std::vector<glm::vec4> irradiance_;
};

}  // namespace ribalta
