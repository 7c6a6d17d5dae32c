// A set-up of the sky's stress test: a planet's air, a viewer and a sun, ordinary or extreme.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "scene/atmosphere.h"

namespace ribalta::stress {

struct SkySetUp {
    std::uint64_t seed = 0;
    int number = 0;
    int kind = 0;  ///< into skyKindNames()
    Atmosphere air;
    double heightMetres = 0.0;  ///< of the viewer above the ground
    double sunElevation = 0.0;  ///< radians above the viewer's mathematical horizon
    double around = 0.0;        ///< azimuth of what is looked at from the sun's, radians
    bool fourOrders = false;    ///< seams are looked for in four orders, else in one
};

/// The classes of set-ups; case n is of class n modulo their number.
std::span<const char* const> skyKindNames();

/// Follows from seed and number alone.
SkySetUp makeSkySetUp(std::uint64_t seed, int number);

/// Its numbers, for people; several lines.
std::string describe(const SkySetUp& setUp);

}  // namespace ribalta::stress
