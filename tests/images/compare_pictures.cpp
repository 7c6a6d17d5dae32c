#include "images/compare_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/check.h"

namespace ribalta::test {
namespace {

constexpr double kEnlargement = 8.0;

std::array<int, 3> colorsOf(const FloatImage& image) {
    const std::array<int, 3> colors{image.channel("R"), image.channel("G"), image.channel("B")};
    CHECK(colors[0] >= 0 && colors[1] >= 0 && colors[2] >= 0);
    return colors;
}

std::uint8_t shade(double codeValues) {
    return static_cast<std::uint8_t>(std::min(codeValues * kEnlargement, 255.0));
}

}  // namespace

Comparison comparePictures(const FloatImage& one, const FloatImage& other,
                           const Tolerance& tolerance) {
    CHECK(one.width == other.width && one.height == other.height);
    const std::array<int, 3> ours = colorsOf(one);
    const std::array<int, 3> theirs = colorsOf(other);
    Comparison result;
    std::size_t off = 0;
    for (int y = 0; y < one.height; ++y) {
        for (int x = 0; x < one.width; ++x) {
            double worst = 0.0;
            for (std::size_t c = 0; c < 3; ++c) {
                const double difference =
                    255.0 * std::abs(double(one.at(x, y, ours[c])) - other.at(x, y, theirs[c]));
                worst =
                    std::max(worst, std::isnan(difference) ? std::numeric_limits<double>::infinity()
                                                           : difference);
            }
            const bool isOff = worst > tolerance.codeValues;
            off += isOff ? 1 : 0;
            result.largest = std::max(result.largest, worst);
            const std::uint8_t grey = shade(worst);
            const std::uint8_t low = isOff ? grey : std::uint8_t(0);
            result.picture.insert(result.picture.end(), {low, low, grey});
        }
    }
    result.shareOff = double(off) / (double(one.width) * double(one.height));
    return result;
}

}  // namespace ribalta::test
