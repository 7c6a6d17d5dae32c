// Rays through a planet's air: as they are asked for, and the part of them that lies in the air.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "scene/atmosphere.h"

namespace ribalta {

/// A view ray from a height above the ground (metres, >= 0; above the air too). Cosines at its
/// start: of ray and zenith (mu), of sun and zenith (muS), of ray and sun (nu; 1 looks into it).
struct SkyRay {
    double heightMetres = 0.0;
    double mu = 1.0;
    double muS = 1.0;
    double nu = 1.0;
    double distanceMetres = std::numeric_limits<double>::infinity();  ///< where it ends, > 0
};

/// What a ray brings, in cd/m2 for a sun of 1 lux (1/sr).
struct SkyLight {
    glm::dvec3 transmittance{1.0};  ///< of the part within the air
    glm::dvec3 air{0.0};            ///< scattered towards the ray's start, of orders 1..`orders`
    glm::dvec3 ground{
        0.0};  ///< reflected by the ground where the ray ends on it, dimmed by the air
};

/// The part of a ray within the air; cosines as in SkyRay, where that part begins.
struct AirPath {
    double height = 0.0;  ///< metres, 0..top
    double mu = 1.0;
    double muS = 1.0;
    double nu = 1.0;
    double length = 0.0;        ///< metres
    bool ground = false;        ///< the whole ray, made endless, hits the ground
    bool endsOnGround = false;  ///< and this part of it gets there
};

/// None where the ray passes the air by, or ends before it. Cosines out of -1..1, and a nu that
/// no three directions have, are taken to the next that can be.
std::optional<AirPath> airPath(const Atmosphere& atmosphere, const SkyRay& ray);

/// The endless ray from within the air that looks at azimuth `cosAzimuth` from the sun's.
AirPath airPathTowards(const Atmosphere& atmosphere, double height, double mu, double muS,
                       double cosAzimuth);

/// A piece of a path on which what is scattered is smooth.
struct PathPiece {
    double first = 0.0;  ///< metres along the path
    double last = 0.0;
    bool risesFromFirst = true;  ///< whether `first` is its lower end
    bool lit = true;             ///< whether the sun is seen from it
};

/// The path cut at its lowest point and at the edges of the planet's shadow, in order.
std::vector<PathPiece> piecesOf(const Atmosphere& atmosphere, const AirPath& path);

}  // namespace ribalta
