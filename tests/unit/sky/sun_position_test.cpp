// The sun's place by time, against published values.
#include "sky/sun_position.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/angles.h"

namespace ribalta::test {
namespace {

double dayAt(int year, int month, int day, double hours) {
    return julianDay(year, month, day + hours / 24.0);
}

TEST(SunPosition, JulianDays) {
    // Meeus, table on page 62.
    EXPECT_DOUBLE_EQ(julianDay(2000, 1, 1.5), 2451545.0);
    EXPECT_DOUBLE_EQ(julianDay(1999, 1, 1.0), 2451179.5);
    EXPECT_DOUBLE_EQ(julianDay(1987, 1, 27.0), 2446822.5);
    EXPECT_DOUBLE_EQ(julianDay(1987, 6, 19.5), 2446966.0);
    EXPECT_DOUBLE_EQ(julianDay(1988, 1, 27.0), 2447187.5);
    EXPECT_DOUBLE_EQ(julianDay(1900, 1, 1.0), 2415020.5);
}

TEST(SunPosition, MeeussExample) {
    // Example 25.a: 1992 October 13 at 0h of dynamical time.
    const SunPlace sun = sunPlace(2448908.5);
    EXPECT_NEAR(sun.longitude / kDegree, 199.90895, 1e-5);
    EXPECT_NEAR(sun.rightAscension / kDegree, 198.38083 - 360.0, 1e-5);
    EXPECT_NEAR(sun.declination / kDegree, -7.78507, 1e-5);
    EXPECT_NEAR(sun.distance, 0.99766, 1e-5);
}

TEST(SunPosition, TheSpringPointAndTheSolstices) {
    // Example 27.a: the summer solstice of 1962 was on June 21 at 21h24m42s of dynamical time.
    EXPECT_NEAR(sunPlace(dayAt(1962, 6, 21, 21.0 + 24.0 / 60 + 42.0 / 3600)).longitude / kDegree,
                90.0, 0.01);
    // Table 27.E: March equinox of 2000 at 7h36m19s, December solstice of 2005 at 18h36m01s.
    EXPECT_NEAR(std::sin(sunPlace(dayAt(2000, 3, 20, 7.0 + 36.0 / 60 + 19.0 / 3600)).longitude),
                0.0, 0.01 * kDegree);
    EXPECT_NEAR(sunPlace(dayAt(2005, 12, 21, 18.0 + 36.0 / 60 + 1.0 / 3600)).longitude / kDegree,
                270.0, 0.01);
}

TEST(SunPosition, NrelsExample) {
    // Reda and Andreas, Solar Position Algorithm for Solar Radiation Applications
    // (NREL/TP-560-34302, 2008), appendix A.5: 17 October 2003 at 12:30:30, seven hours behind, at
    // Golden. Their elevation before refraction.
    const SunInSky sun = sunInSky(dayAt(2003, 10, 17, 19.0 + 30.0 / 60 + 30.0 / 3600),
                                  39.742476 * kDegree, -105.1786 * kDegree);
    EXPECT_NEAR(sun.elevation / kDegree, 39.872046, 0.01);
    EXPECT_NEAR(sun.azimuth / kDegree, 194.340241, 0.01);
}

TEST(SunPosition, NorthIsAwayFromTheCameraAndEastToTheRight) {
    EXPECT_NEAR(towards({0.0, 0.0}).z, -1.0, 1e-12);
    EXPECT_NEAR(towards({0.0, 90.0 * kDegree}).x, 1.0, 1e-12);
    EXPECT_NEAR(towards({90.0 * kDegree, 1.0}).y, 1.0, 1e-12);
    // In the northern hemisphere's summer the sun rises in the north-east, at noon stands in the
    // south and sets in the north-west.
    const double latitude = 50.0 * kDegree;
    const glm::dvec3 rise = towards(sunInSky(dayAt(2026, 6, 21, 4.0), latitude, 0.0));
    EXPECT_GT(rise.x, 0.0);
    EXPECT_LT(rise.z, 0.0);
    const glm::dvec3 noon = towards(sunInSky(dayAt(2026, 6, 21, 12.03), latitude, 0.0));
    EXPECT_NEAR(noon.x, 0.0, 0.01);
    EXPECT_GT(noon.z, 0.0);
    EXPECT_NEAR(noon.y, std::sin((90.0 - 50.0 + 23.437) * kDegree), 1e-3);
    const glm::dvec3 set = towards(sunInSky(dayAt(2026, 6, 21, 20.0), latitude, 0.0));
    EXPECT_LT(set.x, 0.0);
    EXPECT_LT(set.z, 0.0);
    // And in the south at noon it stands in the north.
    EXPECT_LT(towards(sunInSky(dayAt(2026, 6, 21, 12.03), -latitude, 0.0)).z, 0.0);
}

TEST(SunPosition, LongitudeAndTimeAreOne) {
    // An hour later 15 degrees farther west the sun stands where it stood, but for its own way.
    const SunInSky here = sunInSky(dayAt(2026, 9, 10, 9.0), 0.7, 0.2);
    const SunInSky there = sunInSky(dayAt(2026, 9, 10, 10.0), 0.7, 0.2 - 15.0 * kDegree);
    EXPECT_NEAR(here.elevation, there.elevation, 0.02 * kDegree);
    EXPECT_NEAR(here.azimuth, there.azimuth, 0.02 * kDegree);
}

}  // namespace
}  // namespace ribalta::test
