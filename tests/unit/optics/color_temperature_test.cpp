// Colours of black bodies, against Planck's law integrated with the eye's own curves.
#include "optics/color_temperature.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace ribalta {
namespace {

double lobe(double nm, double middle, double below, double above) {
    const double t = (nm - middle) * (nm < middle ? below : above);
    return std::exp(-0.5 * t * t);
}

// CIE 1931 2 degrees, fitted by Wyman, Sloan and Shirley 2013 (multi-lobe).
glm::dvec3 eye(double nm) {
    return {0.362 * lobe(nm, 442.0, 0.0624, 0.0374) + 1.056 * lobe(nm, 599.8, 0.0264, 0.0323) -
                0.065 * lobe(nm, 501.1, 0.0490, 0.0382),
            0.821 * lobe(nm, 568.8, 0.0213, 0.0247) + 0.286 * lobe(nm, 530.9, 0.0613, 0.0322),
            1.217 * lobe(nm, 437.0, 0.0845, 0.0278) + 0.681 * lobe(nm, 459.0, 0.0385, 0.0725)};
}

glm::dvec2 chromaticityOfBlackBody(double kelvin) {
    glm::dvec3 xyz(0.0);
    for (double nm = 370.0; nm <= 800.0; nm += 1.0) {
        const double radiance = std::pow(nm, -5.0) / (std::exp(1.4387769e7 / (nm * kelvin)) - 1.0);
        xyz += radiance * eye(nm);
    }
    return glm::dvec2(xyz.x, xyz.y) / (xyz.x + xyz.y + xyz.z);
}

// The inverse of IEC 61966-2-1's matrix.
glm::dvec2 chromaticityOfLinear(const glm::dvec3& rgb) {
    const glm::dvec3 xyz(glm::dot(glm::dvec3(0.4124564, 0.3575761, 0.1804375), rgb),
                         glm::dot(glm::dvec3(0.2126729, 0.7151522, 0.0721750), rgb),
                         glm::dot(glm::dvec3(0.0193339, 0.1191920, 0.9503041), rgb));
    return glm::dvec2(xyz.x, xyz.y) / (xyz.x + xyz.y + xyz.z);
}

TEST(ColorOfTemperature, IsThatOfABlackBody) {
    // 0.004 is what the eye's fitted curves are off by; below 2000 K the colour leaves sRGB.
    for (double kelvin = 2000.0; kelvin <= 15000.0; kelvin *= 1.1) {
        const glm::dvec3 color = colorOfTemperature(kelvin);
        EXPECT_DOUBLE_EQ(std::max({color.x, color.y, color.z}), 1.0);
        EXPECT_LT(glm::distance(chromaticityOfLinear(color), chromaticityOfBlackBody(kelvin)),
                  0.004)
            << kelvin;
    }
}

TEST(ColorOfTemperature, WarmsSteadilyAndStaysInRange) {
    double before = 0.0;
    for (double kelvin = 1000.0; kelvin <= 40000.0; kelvin += 50.0) {
        const glm::dvec3 color = colorOfTemperature(kelvin);
        const double blueOverRed = color.z / color.x;
        EXPECT_GE(blueOverRed, before) << kelvin;
        EXPECT_GE(std::min({color.x, color.y, color.z}), 0.0) << kelvin;
        before = blueOverRed;
    }
}

}  // namespace
}  // namespace ribalta
