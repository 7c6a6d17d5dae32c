// Optical lengths: how many metres of air as dense as at the ground a way holds. Exact, and as a
// table for those who need millions.
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "scene/atmosphere.h"

namespace ribalta {

/// Rayleigh's and Mie's optical lengths in metres from a height of 0..top along a ray, mu the
/// cosine between it and the zenith, over a distance in metres within the air. Adaptive; good to
/// 1e-12.
glm::dvec2 opticalLengths(const Atmosphere& atmosphere, double height, double mu, double distance);

/// What is left of light, per channel, after a way of those optical lengths.
glm::dvec3 transmittance(const Atmosphere& atmosphere, const glm::dvec2& lengths);

/// The same from 0..top to the air's end, for rays that do not hit the ground: log(optical length /
/// distance) over height and distance (the mapping of Bruneton's 2017 code), by cubics. For Earth's
/// air within 3e-6 (32 heights by 64 cosines: 4e-5), for scale heights an eighth of Earth's within
/// 2e-4.
class OpticalLengthTable {
  public:
    explicit OpticalLengthTable(const Atmosphere& atmosphere, int heights = 128, int cosines = 256);

    glm::dvec2 toTop(double height, double mu) const;
    /// Over `distance` within the air; `ground` where the whole ray hits it. As a difference:
    /// the errors are parts of the way to the air's end, not of this one.
    glm::dvec2 along(double height, double mu, double distance, bool ground) const;

    const Atmosphere& atmosphere() const { return atmosphere_; }
    const std::vector<glm::dvec2>& logs() const { return logs_; }  ///< [height][cosine]

  private:
    Atmosphere atmosphere_;
    int heights_;
    int cosines_;
    std::vector<glm::dvec2> logs_;
};

}  // namespace ribalta
