// SkyDaylight: what sun and sky light surfaces of a scene with, in double precision: the whole
// dome's light at the scene's origin, summed up for each normal.
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "reference/sky_sight.h"

namespace ribalta {

class SkyDaylight {
  public:
    explicit SkyDaylight(const SkySight& sight);

    const glm::dvec3& towardsSun() const { return towardsSun_; }
    /// Unit directions to points that are spread evenly over its disc; at least one.
    const std::vector<glm::dvec3>& sunDisc() const { return sunDisc_; }
    int sunLamp() const { return sunLamp_; }
    /// On a plane that faces the sun, of the part of its disc that is above the horizon.
    const glm::dvec3& sunLux() const { return sunLux_; }
    /// By sky and ground alone, of a surface in free air; `normal` is unit.
    glm::dvec3 irradiance(const glm::dvec3& normal) const;

  private:
    struct Part {
        glm::dvec3 direction;  ///< unit, world
        glm::dvec3 lux;        ///< on a plane that faces it
    };

    glm::dvec3 towardsSun_;
    std::vector<glm::dvec3> sunDisc_;
    int sunLamp_;
    glm::dvec3 sunLux_{0.0};
    std::vector<Part> parts_;
};

}  // namespace ribalta
