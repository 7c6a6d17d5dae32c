// Where the sun stands over a place on Earth at a time, without refraction: the air that the sky is
// made of does not bend light.
#pragma once

#include <glm/glm.hpp>

namespace ribalta {

/// The sun as seen from the Earth's middle, by Meeus, Astronomical Algorithms (2nd ed. 1998),
/// chapter 25, low accuracy: within 0.01 degree in 1900..2100.
struct SunPlace {
    double longitude = 0.0;       ///< apparent ecliptic, radians, 0..2 pi
    double rightAscension = 0.0;  ///< radians, -pi..pi
    double declination = 0.0;     ///< radians
    double distance = 1.0;        ///< astronomical units
};

/// `julianDay` in dynamical time.
SunPlace sunPlace(double julianDay);

/// The sun in the sky of a place.
struct SunInSky {
    double elevation = 0.0;  ///< of its centre above the mathematical horizon, radians
    double azimuth = 0.0;    ///< from north through east, radians, 0..2 pi

    bool operator==(const SunInSky&) const = default;
};

/// `julianDay` in universal time; latitude north and longitude east of Greenwich in radians.
/// Parallax is in it. Good to 0.01 degree in 1900..2100.
SunInSky sunInSky(double julianDay, double latitude, double longitude);

/// A direction of the world, in which north is -Z, east +X and the zenith +Y.
glm::dvec3 towards(const SunInSky& sun);

/// Days since noon of 1 January -4712, of the Gregorian calendar. `day` may have a fraction.
double julianDay(int year, int month, double day);

}  // namespace ribalta
