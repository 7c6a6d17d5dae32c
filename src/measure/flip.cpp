#include "measure/flip.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/angles.h"
#include "base/check.h"
#include "base/parallel_for.h"
#include "optics/shader_lib.h"

namespace ribalta {
namespace {

// The paper's constants (section 5): exponents of colour and feature differences, where the range
// of colour differences is bent, and the width of the feature detector in degrees.
constexpr double kColorExponent = 0.7;
constexpr double kFeatureExponent = 0.5;
constexpr double kBendAt = 0.4;
constexpr double kBentTo = 0.95;
constexpr double kFeatureDegrees = 0.082;

// One Gaussian of a contrast sensitivity function in space: a sqrt(pi / b) exp(-pi^2 x^2 / b), x in
// degrees (table 1).
struct Sensitivity {
    double a;
    double b;
};
constexpr Sensitivity kAchromatic = {1.0, 0.0047};
constexpr Sensitivity kRedGreen = {1.0, 0.0053};
constexpr Sensitivity kBlueYellow[2] = {{34.1, 0.04}, {13.5, 0.025}};

// Linear sRGB to CIE XYZ (IEC 61966-2-1), columns R, G, B, and the white they add up to.
const glm::dmat3 kXyzFromRgb(0.4124564, 0.2126729, 0.0193339, 0.3575761, 0.7151522, 0.1191920,
                             0.1804375, 0.0721750, 0.9503041);
const glm::dmat3 kRgbFromXyz = glm::inverse(kXyzFromRgb);
const glm::dvec3 kWhite = kXyzFromRgb * glm::dvec3(1.0);

// YCxCz, a linear colour space with L*a*b*'s axes: Y in -16..100.
glm::dvec3 opponentFromRgb(const glm::dvec3& linear) {
    const glm::dvec3 c = (kXyzFromRgb * linear) / kWhite;
    return {116.0 * c.y - 16.0, 500.0 * (c.x - c.y), 200.0 * (c.y - c.z)};
}

glm::dvec3 rgbFromOpponent(const glm::dvec3& opponent) {
    const double y = (opponent.x + 16.0) / 116.0;
    return kRgbFromXyz * (glm::dvec3(y + opponent.y / 500.0, y, y - opponent.z / 200.0) * kWhite);
}

// CIE 1976 L*a*b*, its colours dimmed with lightness as Hunt saw (equation 4).
glm::dvec3 huntLab(const glm::dvec3& linear) {
    constexpr double kDelta = 6.0 / 29.0;
    glm::dvec3 f = (kXyzFromRgb * linear) / kWhite;
    for (int i = 0; i < 3; ++i) {
        f[i] = f[i] > kDelta * kDelta * kDelta ? std::cbrt(f[i])
                                               : f[i] / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
    }
    const double lightness = 116.0 * f.y - 16.0;
    return {lightness, 0.01 * lightness * 500.0 * (f.x - f.y),
            0.01 * lightness * 200.0 * (f.y - f.z)};
}

// The HyAB distance (Abasi et al. 2020), for large differences.
double hyab(const glm::dvec3& a, const glm::dvec3& b) {
    return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

// A row or column of a separable filter of four values a pixel: weights for offsets
// -radius..radius.
using Taps = std::vector<glm::vec4>;

Taps sensitivityTaps(double pixelsPerDegree) {
    const double widest = kBlueYellow[0].b;
    const int radius =
        int(std::ceil(3.0 * std::sqrt(widest / (2.0 * kPi * kPi)) * pixelsPerDegree));
    Taps taps;
    for (int i = -radius; i <= radius; ++i) {
        const double x = i / pixelsPerDegree;
        const auto bell = [&](const Sensitivity& s) { return std::exp(-kPi * kPi * x * x / s.b); };
        taps.emplace_back(bell(kAchromatic), bell(kRedGreen), bell(kBlueYellow[0]),
                          bell(kBlueYellow[1]));
    }
    glm::dvec4 sums(0.0);
    for (const glm::vec4& tap : taps) {
        sums += glm::dvec4(tap);
    }
    // Blue-yellow is a sum of two bells in the plane, whose shares the two directions split.
    const auto volume = [&](const Sensitivity& s, double sum) {
        return s.a * std::sqrt(kPi / s.b) * sum * sum;
    };
    const double wide = volume(kBlueYellow[0], sums.z);
    const double narrow = volume(kBlueYellow[1], sums.w);
    const glm::dvec4 scale(1.0 / sums.x, 1.0 / sums.y, std::sqrt(wide / (wide + narrow)) / sums.z,
                           std::sqrt(narrow / (wide + narrow)) / sums.w);
    for (glm::vec4& tap : taps) {
        tap = glm::vec4(glm::dvec4(tap) * scale);
    }
    return taps;
}

// Taps of a Gaussian (x), of its first (y) and of its second derivative (z), each with positive
// weights that add up to 1 and, for derivatives, negative ones that add up to -1 (section 4.2).
Taps featureTaps(double pixelsPerDegree) {
    const double sigma = 0.5 * kFeatureDegrees * pixelsPerDegree;
    const int radius = int(std::ceil(3.0 * sigma));
    std::vector<glm::dvec3> raw;
    glm::dvec3 positive(0.0);
    glm::dvec3 negative(0.0);
    for (int x = -radius; x <= radius; ++x) {
        const double bell = std::exp(-x * x / (2.0 * sigma * sigma));
        raw.push_back(bell * glm::dvec3(1.0, -x, x * x / (sigma * sigma) - 1.0));
        positive += glm::max(raw.back(), glm::dvec3(0.0));
        negative -= glm::min(raw.back(), glm::dvec3(0.0));
    }
    Taps taps;
    for (const glm::dvec3& value : raw) {
        glm::vec4 tap(0.0F);
        for (int i = 0; i < 3; ++i) {
            const double sum = value[i] > 0.0 ? positive[i] : negative[i];
            tap[i] = sum > 0.0 ? float(value[i] / sum) : 0.0F;
        }
        taps.push_back(tap);
    }
    return taps;
}

// Calls sum(place, tap) for every tap, centred at `at` along one axis of `size` pixels; the
// picture's edge goes on beyond it.
template <typename Sum>
void forTaps(const Taps& taps, int at, int size, const Sum& sum) {
    int place = at - int(taps.size() / 2);
    for (const glm::vec4& tap : taps) {
        sum(std::clamp(place, 0, size - 1), tap);
        ++place;
    }
}

struct Plane {
    int width;
    int height;
    std::vector<glm::vec4> values;

    Plane(int w, int h) : width(w), height(h), values(std::size_t(w) * std::size_t(h)) {}
    glm::vec4& at(int x, int y) {
        return values[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    }
    const glm::vec4& at(int x, int y) const {
        return values[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    }
    /// Calls set(x, y) for every pixel, rows in parallel.
    template <typename Set>
    void forPixels(const Set& set) const {
        parallelFor(std::size_t(height), [&](std::size_t row) {
            for (int x = 0; x < width; ++x) {
                set(x, int(row));
            }
        });
    }
};

// Y, Cx, Cz, Cz: blue-yellow has two filters.
Plane opponentPlane(const RgbPicture& display) {
    Plane plane(display.width, display.height);
    plane.forPixels([&](int x, int y) {
        const glm::dvec3 encoded(display.at(x, y));
        const glm::dvec3 color = opponentFromRgb(shader::srgbDecode(encoded));
        plane.at(x, y) = glm::vec4(color.x, color.y, color.z, color.z);
    });
    return plane;
}

void filterColors(const Plane& opponent, double pixelsPerDegree, FlipView& view) {
    const Taps taps = sensitivityTaps(pixelsPerDegree);
    Plane across(opponent.width, opponent.height);
    across.forPixels([&](int x, int y) {
        glm::vec4 sum(0.0F);
        forTaps(taps, x, opponent.width,
                [&](int at, const glm::vec4& tap) { sum += tap * opponent.at(at, y); });
        across.at(x, y) = sum;
    });
    across.forPixels([&](int x, int y) {
        glm::vec4 sum(0.0F);
        forTaps(taps, y, opponent.height,
                [&](int at, const glm::vec4& tap) { sum += tap * across.at(x, at); });
        const glm::dvec3 rgb = rgbFromOpponent(glm::dvec3(sum.x, sum.y, sum.z + sum.w));
        view.colors[std::size_t(y) * std::size_t(view.width) + std::size_t(x)] =
            glm::vec3(huntLab(glm::clamp(rgb, glm::dvec3(0.0), glm::dvec3(1.0))));
    });
}

void filterFeatures(const Plane& opponent, double pixelsPerDegree, FlipView& view) {
    const Taps taps = featureTaps(pixelsPerDegree);
    // Lightness in 0..1 along x: smoothed, first and second derivative.
    Plane across(opponent.width, opponent.height);
    across.forPixels([&](int x, int y) {
        glm::vec4 sum(0.0F);
        forTaps(taps, x, opponent.width, [&](int at, const glm::vec4& tap) {
            sum += tap * ((opponent.at(at, y).x + 16.0F) / 116.0F);
        });
        across.at(x, y) = sum;
    });
    across.forPixels([&](int x, int y) {
        glm::vec2 edge(0.0F);
        glm::vec2 point(0.0F);
        forTaps(taps, y, opponent.height, [&](int at, const glm::vec4& tap) {
            const glm::vec4& value = across.at(x, at);
            edge += glm::vec2(tap.x * value.y, tap.y * value.x);
            point += glm::vec2(tap.x * value.z, tap.z * value.x);
        });
        view.features[std::size_t(y) * std::size_t(view.width) + std::size_t(x)] = {
            glm::length(edge), glm::length(point)};
    });
}

// The largest colour difference there is: green against blue.
double largestColorDifference() {
    static const double largest =
        std::pow(hyab(huntLab({0.0, 1.0, 0.0}), huntLab({0.0, 0.0, 1.0})), kColorExponent);
    return largest;
}

// 0..1: small differences take most of the range (equation 7).
double bend(double difference) {
    const double largest = largestColorDifference();
    const double knee = kBendAt * largest;
    if (difference < knee) {
        return kBentTo * difference / knee;
    }
    return std::min(1.0, kBentTo + (1.0 - kBentTo) * (difference - knee) / (largest - knee));
}

}  // namespace

FlipView flipView(const RgbPicture& display, double pixelsPerDegree) {
    FlipView view{display.width, display.height, {}, {}};
    view.colors.resize(display.pixels.size());
    view.features.resize(display.pixels.size());
    const Plane opponent = opponentPlane(display);
    filterColors(opponent, pixelsPerDegree, view);
    filterFeatures(opponent, pixelsPerDegree, view);
    return view;
}

std::vector<float> flipErrors(const FlipView& a, const FlipView& b) {
    CHECK(a.width == b.width && a.height == b.height);
    std::vector<float> errors(a.colors.size());
    const auto width = std::size_t(a.width);
    parallelFor(std::size_t(a.height), [&](std::size_t row) {
        for (std::size_t i = row * width; i < (row + 1) * width; ++i) {
            const double color = bend(
                std::pow(hyab(glm::dvec3(a.colors[i]), glm::dvec3(b.colors[i])), kColorExponent));
            const glm::vec2 apart = glm::abs(a.features[i] - b.features[i]);
            const double feature = std::pow(
                double(std::max(apart.x, apart.y)) / std::numbers::sqrt2, kFeatureExponent);
            errors[i] = float(std::pow(color, 1.0 - std::min(feature, 1.0)));
        }
    });
    return errors;
}

}  // namespace ribalta
