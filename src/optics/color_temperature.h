// The colour of a black body, as lamps are labelled with.
#pragma once

#include <glm/glm.hpp>

namespace ribalta {

/// Range of colorOfTemperature(), in kelvin.
inline constexpr double kLowestKelvin = 1667.0;
inline constexpr double kHighestKelvin = 25000.0;

/// Linear sRGB of a black body, its brightest channel 1 and none below 0. Chromaticities by the
/// cubic splines of Kang et al., "Design of Advanced Color Temperature Control System for HDTV
/// Applications", 2002 (within 0.001 of Planck's law). `kelvin` is kept within the range above.
glm::dvec3 colorOfTemperature(double kelvin);

}  // namespace ribalta
