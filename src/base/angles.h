// Pi and degrees in double precision, for what is computed on the processor; shaders have
// lib/pi.glsl.
#pragma once

#include <numbers>

namespace ribalta {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kDegree = kPi / 180.0;  ///< radians
inline constexpr double kDegreesPerRadian = 180.0 / kPi;

}  // namespace ribalta
