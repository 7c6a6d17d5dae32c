// What the air scatters at each height under each sun into each direction, order by order, as
// tables: how light of the sky that was scattered more than twice is found.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "sky/optical_length.h"
#include "sky/sky_field.h"
#include "sky/sky_ray.h"

namespace ribalta {

/// How finely sources are tabulated, and by how many nodes they are summed up. What is here at
/// first is within 3e-5 of finer tables' orders 3 and 4 (median; 95 % of rays within 1e-3), for
/// Earth.
struct SkyTableSizes {
    int heights = 24;
    int suns = 72;
    int zenithAngles = 37;
    int azimuths = 19;
    DirectionCounts firstDirections{24, 18, 29};  ///< of light once scattered, which peaks
    DirectionCounts laterDirections{16, 12, 13};
    int nodesOfFirst = 20;  ///< of each piece of a ray through light once scattered
    int nodesOfLater = 12;
};

/// Five times as fast; within 1e-3 (median; 95 % within 1e-2).
SkyTableSizes coarseSkyTables();

/// As coarse as a picture may have it, and fifty times as fast: of the sum of all orders within
/// 5e-4 (median; 95 % within 2e-3), with the sun 4 degrees below the horizon 2e-3 (8e-3).
SkyTableSizes pictureSkyTables();

/// Sources of the orders 2..orders. An order's source is the radiance of the order before, weighted
/// with the phase functions and summed over all directions. It is smooth; between the nodes lie
/// cubics.
class SkySources {
  public:
    /// [height][sun][zenith angle][azimuth][6]: Rayleigh's and Mie's colours.
    using Grid = std::vector<float>;

    /// Makes what `paths` need, on all cores. `table` must outlive it. With groundLightsAir light
    /// that the ground reflects takes part, a reflection counting as a scattering.
    SkySources(const OpticalLengthTable& table, int orders, bool groundLightsAir,
               const SkyTableSizes& sizes, std::span<const AirPath> paths);
    /// The same for all paths under all suns.
    SkySources(const OpticalLengthTable& table, int orders, bool groundLightsAir,
               const SkyTableSizes& sizes);

    /// What makeOrder() left of all orders, by which they need not be made again.
    struct Tables {
        std::vector<Grid> grids;                           ///< by order - 2
        std::vector<std::vector<glm::dvec3>> irradiances;  ///< by order - 1, by sun
    };
    /// By tables of the same atmosphere, ground and sizes, of all suns.
    SkySources(const OpticalLengthTable& table, bool groundLightsAir, const SkyTableSizes& sizes,
               Tables tables);
    const Tables& tables() const { return tables_; }

    /// Radiance of exactly `order` 2..orders along a path out of those, for a sun of irradiance 1.
    glm::dvec3 along(const AirPath& path, int order) const;
    /// Irradiance of the ground where a path out of those meets it, under a sun of cosine muS, by
    /// light of exactly `order` 1..orders - 1.
    glm::dvec3 irradiance(int order, double muS) const;

    /// All orders' sources in one; with `closed` also those of the orders beyond the last, which is
    /// then the fourth or higher: at each height under each sun they go on falling as from the last
    /// but one to the last.
    Grid sum(bool closed) const;
    /// The ground's by all light of the sky that it may still reflect, orders 1..orders - 1, closed
    /// as sum() is.
    glm::dvec3 irradianceOfAll(bool closed, double muS) const;
    /// Out of a grid: what is scattered at a height under a sun of cosine muS towards a direction,
    /// by Rayleigh's and Mie's air; angles in radians, 0..pi, azimuths from the sun's.
    std::array<double, 6> at(const Grid& grid, double height, double muS, double zenithAngle,
                             double azimuth) const;
    /// Radiance by a grid's sources along a path in `nodes`.
    glm::dvec3 march(const Grid& grid, const AirPath& path,
                     const std::vector<PathNode>& nodes) const;
    /// Where cosines of the sun lie among those tabulated: asinh(muS / scale), from first to last.
    double sunScale() const { return sunScale_; }
    double firstSun() const { return firstSun_; }
    double lastSun() const { return lastSun_; }

  private:
    void placeNodes();
    void wantSuns(std::span<const AirPath> paths, int orders);
    void makeOrder(int order);
    std::vector<glm::dvec3> field(int order, double height, double muS,
                                  const SkyDirections& directions) const;
    void addGround(int order, double height, double muS, const SkyDirections& directions,
                   std::vector<glm::dvec3>& field) const;
    double sunPlace(double muS) const;
    std::size_t directionSize() const;

    const OpticalLengthTable* table_;
    bool groundLightsAir_;
    SkyTableSizes sizes_;
    GaussRule alongFirst_;
    GaussRule alongLater_;
    double sunScale_ = 1.0;  ///< cosine up to which suns lie evenly
    double firstSun_ = 0.0;  ///< asinh(muS / sunScale_) of the first and the last
    double lastSun_ = 0.0;
    std::vector<double> heights_;
    std::vector<double> suns_;               ///< cosines
    std::vector<std::vector<bool>> wanted_;  ///< by order - 2, by sun
    Tables tables_;
};

}  // namespace ribalta
