// Photometry: single numbers for light that the program needs outside shaders. No pictures.
#include "optics/photometry.h"

#include <cmath>

#include "base/check.h"

namespace ribalta {

double luminance(const glm::dvec3& linear) {
    return 0.2126 * linear.x + 0.7152 * linear.y + 0.0722 * linear.z;
}

double ev100FromAverageLuminance(double candelaPerSquareMetre) {
    CHECK(candelaPerSquareMetre > 0.0);
    return std::log2(candelaPerSquareMetre * 100.0 / 12.5);
}

double ev100FromWhiteLuminance(double candelaPerSquareMetre) {
    CHECK(candelaPerSquareMetre > 0.0);
    return std::log2(candelaPerSquareMetre / 1.2);
}

}  // namespace ribalta
