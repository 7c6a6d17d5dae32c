#include "measure/picture_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/check.h"

namespace ribalta {
namespace {

// Sum over all pixels and channels of `square`(a's value, b's value).
template <typename Square>
double sumOver(const RgbPicture& a, const RgbPicture& b, const Square& square) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            sum += square(double(a.pixels[i][c]), double(b.pixels[i][c]));
        }
    }
    return sum;
}

double squaredDifference(double a, double b) {
    return (a - b) * (a - b);
}

LargestError largestError(const RgbPicture& a, const RgbPicture& b) {
    LargestError largest;
    largest.a = double(a.pixels.front().x);
    largest.b = double(b.pixels.front().x);
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            for (int c = 0; c < 3; ++c) {
                const LargestError here{x, y, c, double(a.at(x, y)[c]), double(b.at(x, y)[c])};
                if (here.size() > largest.size()) {
                    largest = here;
                }
            }
        }
    }
    return largest;
}

double toByte(double display) {
    return std::round(255.0 * std::clamp(display, 0.0, 1.0));
}

void checkSameShape(const RgbPicture& a, const RgbPicture& b) {
    CHECK(a.width == b.width && a.height == b.height && !a.pixels.empty());
    CHECK(a.pixels.size() == b.pixels.size());
}

}  // namespace

LinearError linearError(const RgbPicture& a, const RgbPicture& b) {
    checkSameShape(a, b);
    const double difference = sumOver(a, b, squaredDifference);
    const double size = sumOver(a, b, [](double, double right) { return right * right; });
    LinearError error;
    if (difference > 0.0) {
        error.relativeRmse =
            size > 0.0 ? std::sqrt(difference / size) : std::numeric_limits<double>::infinity();
    }
    error.largest = largestError(a, b);
    return error;
}

double displayRmsePercent(const RgbPicture& a, const RgbPicture& b) {
    checkSameShape(a, b);
    return 100.0 * std::sqrt(sumOver(a, b, squaredDifference) / (3.0 * double(a.pixels.size())));
}

DisplayError displayError(const RgbPicture& a, const RgbPicture& b) {
    return displayError(a, b, flipView(b));
}

DisplayError displayError(const RgbPicture& a, const RgbPicture& b, const FlipView& viewOfB) {
    checkSameShape(a, b);
    const double count = 3.0 * double(a.pixels.size());
    DisplayError error;
    error.rmsePercent = displayRmsePercent(a, b);
    const double meanSquare = sumOver(a, b,
                                      [](double left, double right) {
                                          return squaredDifference(toByte(left), toByte(right));
                                      }) /
                              count;
    error.psnr = meanSquare > 0.0 ? 10.0 * std::log10(255.0 * 255.0 / meanSquare)
                                  : std::numeric_limits<double>::infinity();
    const std::vector<float> flip = flipErrors(flipView(a), viewOfB);
    error.flipMean = std::accumulate(flip.begin(), flip.end(), 0.0) / double(flip.size());
    error.flipLargest = double(*std::max_element(flip.begin(), flip.end()));
    error.largest = largestError(a, b);
    return error;
}

}  // namespace ribalta
