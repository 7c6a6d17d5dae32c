#include "sky/sun_position.h"

#include <cmath>

#include "base/angles.h"
#include "scene/bearing.h"

namespace ribalta {
namespace {

constexpr double kJ2000 = 2451545.0;
constexpr double kCentury = 36525.0;  // days
// Dynamical less universal time: 63 to 69 s in 1996..2026, within two minutes of it in 1900..2100,
// in which the sun moves by less than 0.0015 degrees.
constexpr double kDeltaDays = 68.0 / 86400.0;
constexpr double kParallax = 8.794 / 3600.0 * kDegree;  // at a distance of 1

double turned(double radians) {
    const double rest = std::fmod(radians, 2.0 * kPi);
    return rest < 0.0 ? rest + 2.0 * kPi : rest;
}

}  // namespace

SunPlace sunPlace(double julianDay) {
    const double t = (julianDay - kJ2000) / kCentury;
    const double meanLongitude = 280.46646 + t * (36000.76983 + t * 0.0003032);
    const double anomalyDegrees = 357.52911 + t * (35999.05029 - t * 0.0001537);
    const double anomaly = anomalyDegrees * kDegree;
    const double eccentricity = 0.016708634 - t * (0.000042037 + t * 0.0000001267);
    const double centre = (1.914602 - t * (0.004817 + t * 0.000014)) * std::sin(anomaly) +
                          (0.019993 - t * 0.000101) * std::sin(2.0 * anomaly) +
                          0.000289 * std::sin(3.0 * anomaly);
    // Nutation and aberration.
    const double node = (125.04 - 1934.136 * t) * kDegree;
    const double longitude =
        (meanLongitude + centre - 0.00569 - 0.00478 * std::sin(node)) * kDegree;
    const double obliquity =
        (23.0 + 26.0 / 60.0 + (21.448 - t * (46.8150 + t * (0.00059 - t * 0.001813))) / 3600.0 +
         0.00256 * std::cos(node)) *
        kDegree;
    SunPlace place;
    place.longitude = turned(longitude);
    place.rightAscension =
        std::atan2(std::cos(obliquity) * std::sin(longitude), std::cos(longitude));
    place.declination = std::asin(std::sin(obliquity) * std::sin(longitude));
    place.distance = 1.000001018 * (1.0 - eccentricity * eccentricity) /
                     (1.0 + eccentricity * std::cos(anomaly + centre * kDegree));
    return place;
}

SunInSky sunInSky(double julianDay, double latitude, double longitude) {
    const SunPlace place = sunPlace(julianDay + kDeltaDays);
    const double days = julianDay - kJ2000;
    const double t = days / kCentury;
    // Greenwich mean sidereal time (Meeus, 12.4); that of the true equinox is within 0.0003 degrees
    // of what the right ascension's nutation asks for.
    const double sidereal =
        (280.46061837 + 360.98564736629 * days + t * t * (0.000387933 - t / 38710000.0)) * kDegree;
    const double hour = sidereal + longitude - place.rightAscension;
    const double sine = std::sin(latitude) * std::sin(place.declination) +
                        std::cos(latitude) * std::cos(place.declination) * std::cos(hour);
    const double south = std::cos(hour) * std::sin(latitude) * std::cos(place.declination) -
                         std::sin(place.declination) * std::cos(latitude);
    const double west = std::sin(hour) * std::cos(place.declination);
    SunInSky sun;
    sun.elevation = std::atan2(sine, std::hypot(south, west));
    sun.elevation -= kParallax / place.distance * std::cos(sun.elevation);
    sun.azimuth = turned(std::atan2(west, south) + kPi);
    return sun;
}

glm::dvec3 towards(const SunInSky& sun) {
    return directionOf({sun.azimuth, sun.elevation});
}

// Meeus, chapter 7.
double julianDay(int year, int month, double day) {
    const int shiftedYear = month <= 2 ? year - 1 : year;
    const int shiftedMonth = month <= 2 ? month + 12 : month;
    const int century = int(std::floor(shiftedYear / 100.0));
    return std::floor(365.25 * (shiftedYear + 4716)) + std::floor(30.6001 * (shiftedMonth + 1)) +
           day + (2 - century + int(std::floor(century / 4.0))) - 1524.5;
}

}  // namespace ribalta
