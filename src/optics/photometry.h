// Photometry: single numbers for light that the program needs outside shaders. No pictures.
#pragma once

#include <glm/glm.hpp>

namespace ribalta {

/// Luminance in cd/m2 of linear sRGB channels in cd/m2 (Rec. 709 weights: 1, 1, 1 gives 1).
double luminance(const glm::dvec3& linear);

/// The exposure value at ISO 100 that a reflected-light meter of calibration 12.5 (ISO 2720) sets
/// for an average luminance in cd/m2, > 0: that luminance is then shown at 0.104 of the white that
/// shader::exposureFromEv100 maps to 1.
double ev100FromAverageLuminance(double candelaPerSquareMetre);

/// The exposure value at ISO 100 under which a luminance in cd/m2, > 0, is exposed to 1.
double ev100FromWhiteLuminance(double candelaPerSquareMetre);

}  // namespace ribalta
