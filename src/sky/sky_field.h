// What light of the sky, scattered once, comes from all directions to a point within the air, and
// the quadrature over those directions and along rays that later orders share.
#pragma once

#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "base/gauss_rule.h"
#include "sky/optical_length.h"
#include "sky/sky_ray.h"

namespace ribalta {

/// Directions at a height: cosines from the zenith, dense around the horizon and never across it,
/// times azimuths from the sun's, 0..pi evenly. The sky is the same left and right of the sun.
struct SkyDirections {
    std::vector<double> mu;
    std::vector<double> weights;         ///< of mu; sum 2
    std::vector<double> cosAzimuths;     ///< from 1 to -1
    std::vector<double> azimuthWeights;  ///< both sides; sum 2 pi

    std::size_t count() const { return mu.size() * cosAzimuths.size(); }
};
struct DirectionCounts {
    int above = 32;  ///< the horizon
    int below = 24;
    int azimuths = 33;
};
SkyDirections directionsAt(const Atmosphere& atmosphere, double height,
                           const DirectionCounts& counts);

/// A place on a path with what light scattered there is worth at the path's start: weight times
/// density times scattering times transmittance, 1; times phase and radiance it adds up.
struct PathNode {
    double t = 0.0;       ///< metres along the path
    double height = 0.0;  ///< metres
    glm::dvec3 rayleigh{0.0};
    glm::dvec3 mie{0.0};
};

/// Appends the nodes of a piece: Gauss' rule in the square root of the way from its lower end.
void addNodes(const OpticalLengthTable& table, const AirPath& path, const PathPiece& piece,
              const GaussRule& rule, std::vector<PathNode>& nodes);

/// Order 1 from all `directions` to a point under a sun of cosine muS: radiance for a sun of
/// irradiance 1 at [i azimuths + j]. `ruleAlong` is the rule of each piece of each ray.
std::vector<glm::dvec3> firstOrderField(const OpticalLengthTable& table, double height, double muS,
                                        const SkyDirections& directions,
                                        const GaussRule& ruleAlong);

/// 0..1, per channel: what of the sun's light gets to a point; 0 where the ground hides it.
glm::dvec3 sunTransmittance(const OpticalLengthTable& table, double height, double muS);

/// Where a path meets the ground: the sun's cosine there, and what of an irradiance there comes to
/// the path's start as radiance (albedo / pi times transmittance), 1/sr.
struct GroundView {
    double muS = 1.0;
    glm::dvec3 reflectance{0.0};
};
GroundView groundView(const OpticalLengthTable& table, const AirPath& path);

/// On the ground, for a sun of irradiance 1 and cosine muS: by the sun itself, and by the light of
/// `field` from the directions at height 0.
glm::dvec3 sunIrradiance(const OpticalLengthTable& table, double muS);
glm::dvec3 irradianceOf(const SkyDirections& directions, std::span<const glm::dvec3> field);

/// Radiance at the start of a path that ends on the ground, by the ground's diffuse reflection of
/// `irradiance(muS)`, a glm::dvec3, muS being the sun's cosine there.
template <typename Irradiance>
glm::dvec3 groundLight(const OpticalLengthTable& table, const AirPath& path,
                       const Irradiance& irradiance) {
    const GroundView view = groundView(table, path);
    return view.reflectance * irradiance(view.muS);
}

}  // namespace ribalta
