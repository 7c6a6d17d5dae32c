// The sum over all directions of light times phase function, for many outgoing directions at once:
// Fourier's modes of the azimuth, in which such a sum is a product.
#pragma once

#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "sky/sky_field.h"

namespace ribalta {

/// Takes the light of `directions` to `zenithAngles` x `azimuths` outgoing directions, each evenly
/// over 0..pi. Modes up to 20 are kept; those of a sun's aureole beyond are below 1e-4 of it.
class PhaseProjection {
  public:
    PhaseProjection(const SkyDirections& directions, double mieG, int zenithAngles, int azimuths);

    /// `field` at [direction's mu, azimuth]; `out` [zenith angle][azimuth][6]: the sum with
    /// Rayleigh's phase function, then that with Mie's.
    void apply(std::span<const glm::dvec3> field, std::span<float> out) const;

  private:
    static constexpr int kModes = 21;

    SkyDirections directions_;
    int zenithAngles_;
    int azimuths_;
    std::vector<glm::dvec2> kernels_;  ///< [mode][outgoing zenith angle][direction's mu]
};

}  // namespace ribalta
