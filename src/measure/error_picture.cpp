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

// A picture of `picture`'s pixels joined in squares until it is at most `maxWidth` wide;
// color(left, top, right, bottom) gives a square's display colour.
template <typename Color>
BytePicture shrink(const RgbPicture& picture, int maxWidth, const Color& color) {
    const int side = (picture.width + maxWidth - 1) / maxWidth;
    BytePicture result{(picture.width + side - 1) / side, (picture.height + side - 1) / side, {}};
    for (int y = 0; y < picture.height; y += side) {
        for (int x = 0; x < picture.width; x += side) {
            const glm::dvec3 value =
                color(x, y, std::min(x + side, picture.width), std::min(y + side, picture.height));
            for (int c = 0; c < 3; ++c) {
                result.rgb.push_back(
                    std::uint8_t(std::lround(255.0 * std::clamp(value[c], 0.0, 1.0))));
            }
        }
    }
    return result;
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

BytePicture errorPicture(const RgbPicture& a, const RgbPicture& b, double fullPercent,
                         int maxWidth) {
    CHECK(a.pixels.size() == b.pixels.size() && fullPercent > 0.0);
    constexpr int kSteps = 1024;
    std::vector<glm::dvec3> colors;
    for (int i = 0; i <= kSteps; ++i) {
        colors.push_back(errorColor(double(i) / kSteps));
    }
    return shrink(a, maxWidth, [&](int left, int top, int right, int bottom) {
        float largest = 0.0F;
        for (int y = top; y < bottom; ++y) {
            for (int x = left; x < right; ++x) {
                const glm::vec3 apart = glm::abs(a.at(x, y) - b.at(x, y));
                largest = std::max({largest, apart.x, apart.y, apart.z});
            }
        }
        const double error = 100.0 * double(largest) / fullPercent;
        return colors[std::size_t(std::lround(kSteps * std::min(error, 1.0)))];
    });
}

BytePicture smallPicture(const RgbPicture& display, int maxWidth) {
    return shrink(display, maxWidth, [&](int left, int top, int right, int bottom) {
        glm::dvec3 sum(0.0);
        for (int y = top; y < bottom; ++y) {
            for (int x = left; x < right; ++x) {
                sum += glm::dvec3(display.at(x, y));
            }
        }
        return sum / double((right - left) * (bottom - top));
    });
}

}  // namespace ribalta
