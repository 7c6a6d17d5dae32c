// Pi in double precision, for what is computed on the processor; shaders have lib/pi.glsl.
#pragma once

#include <numbers>

namespace ribalta {

inline constexpr double kPi = std::numbers::pi;

}  // namespace ribalta
