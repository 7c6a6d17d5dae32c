#include "measure/error_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/check.h"
#include "optics/shader_lib.h"

namespace ribalta {
namespace {

// Linear sRGB of Oklab (Ottosson 2020).
glm::dvec3 linearFromOklab(double lightness, double a, double b) {
    const double l = lightness + 0.3963377774 * a + 0.2158037573 * b;
    const double m = lightness - 0.1055613458 * a - 0.0638541728 * b;
    const double s = lightness - 0.0894841775 * a - 1.2914855480 * b;
    const glm::dvec3 lms(l * l * l, m * m * m, s * s * s);
    return {4.0767416621 * lms.x - 3.3077115913 * lms.y + 0.2309699292 * lms.z,
            -1.2684380046 * lms.x + 2.6097574011 * lms.y - 0.3413193965 * lms.z,
            -0.0041960863 * lms.x - 0.7034186147 * lms.y + 1.7076147010 * lms.z};
}

bool isShown(const glm::dvec3& linear) {
    return glm::all(glm::greaterThanEqual(linear, glm::dvec3(-1e-6))) &&
           glm::all(glm::lessThanEqual(linear, glm::dvec3(1.0 + 1e-6)));
}

}  // namespace

glm::dvec3 errorColor(double error) {
    const double t = std::clamp(error, 0.0, 1.0);
    // From violet over red to yellow, as saturated as a screen shows at this lightness.
    const double hue = (-65.0 + 175.0 * t) * std::numbers::pi / 180.0;
    double chroma = 0.22 * std::sin(std::numbers::pi * std::pow(t, 0.7));
    glm::dvec3 linear = linearFromOklab(t, chroma * std::cos(hue), chroma * std::sin(hue));
    while (!isShown(linear) && chroma > 1e-3) {
        chroma *= 0.98;
        linear = linearFromOklab(t, chroma * std::cos(hue), chroma * std::sin(hue));
    }
    return shader::srgbEncode(linear);
}

std::vector<std::uint8_t> errorPicture(const RgbPicture& a, const RgbPicture& b,
                                       double fullPercent) {
    CHECK(a.pixels.size() == b.pixels.size() && fullPercent > 0.0);
    constexpr int kSteps = 1024;
    std::vector<glm::dvec3> colors;
    for (int i = 0; i <= kSteps; ++i) {
        colors.push_back(errorColor(double(i) / kSteps));
    }
    std::vector<std::uint8_t> bytes;
    bytes.reserve(3 * a.pixels.size());
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const glm::vec3 apart = glm::abs(a.pixels[i] - b.pixels[i]);
        const double error = 100.0 * double(std::max({apart.x, apart.y, apart.z})) / fullPercent;
        const auto step = std::size_t(std::lround(kSteps * std::min(error, 1.0)));
        for (int c = 0; c < 3; ++c) {
            bytes.push_back(std::uint8_t(std::lround(255.0 * colors[step][c])));
        }
    }
    return bytes;
}

}  // namespace ribalta
