#include "optics/color_temperature.h"

#include <algorithm>

namespace ribalta {
namespace {

// CIE 1931 chromaticities x, y.
glm::dvec2 planckianLocus(double kelvin) {
    const double t = 1000.0 / kelvin;
    const double x = kelvin <= 4000.0
                         ? ((-0.2661239 * t - 0.2343589) * t + 0.8776956) * t + 0.179910
                         : ((-3.0258469 * t + 2.1070379) * t + 0.2226347) * t + 0.240390;
    double y = 0.0;
    if (kelvin <= 2222.0) {
        y = ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683;
    } else if (kelvin <= 4000.0) {
        y = ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867;
    } else {
        y = ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483;
    }
    return {x, y};
}

}  // namespace

glm::dvec3 colorOfTemperature(double kelvin) {
    const glm::dvec2 xy = planckianLocus(std::clamp(kelvin, kLowestKelvin, kHighestKelvin));
    const glm::dvec3 xyz(xy.x / xy.y, 1.0, (1.0 - xy.x - xy.y) / xy.y);
    // IEC 61966-2-1 (sRGB), D65.
    const glm::dvec3 linear(glm::dot(glm::dvec3(3.2404542, -1.5371385, -0.4985314), xyz),
                            glm::dot(glm::dvec3(-0.9692660, 1.8760108, 0.0415560), xyz),
                            glm::dot(glm::dvec3(0.0556434, -0.2040259, 1.0572252), xyz));
    const glm::dvec3 inside = glm::max(linear, glm::dvec3(0.0));
    return inside / std::max({inside.x, inside.y, inside.z});
}

}  // namespace ribalta
