// Closed forms of single scattering along a ray.
#include "reference/closed_forms.h"

#include <array>
#include <cmath>

#include "base/angles.h"
#include "base/check.h"

namespace ribalta {
namespace {

/// Scattering angle at s: 0 far before the lamp (straight on), pi far behind it.
double scatteringAngle(double h, double s) {
    return std::atan2(h, -s);
}

/// Sun's special function over a range, F(u, v1) - F(u, v0) with F(u, v) = integral of exp(-u tan
/// x) from 0 to v <= pi / 2. Tanh-sinh quadrature (Takahasi & Mori 1974), which does not mind the
/// layer at pi / 2 where the tangent blows up.
double sunIntegral(double u, double v0, double v1) {
    constexpr int kSteps = 120;
    constexpr double kStep = 3.4 / kSteps;
    const double half = 0.5 * (v1 - v0);
    const double centre = 0.5 * (v1 + v0);
    double sum = 0.0;
    for (int i = -kSteps; i <= kSteps; ++i) {
        const double t = kStep * i;
        const double argument = 0.5 * kPi * std::sinh(t);
        const double cosine = std::cosh(argument);
        const double weight = 0.5 * kPi * std::cosh(t) / (cosine * cosine);
        const double x = centre + half * std::tanh(argument);
        if (x < 0.5 * kPi) {
            sum += weight * std::exp(-u * std::tan(x));
        }
    }
    return half * kStep * sum;
}

}  // namespace

double isotropicPointSource(double h, double eyeToNearest, double s0, double s1,
                            double scatteringPerMetre, double extinctionPerMetre) {
    CHECK(h > 0.0 && s0 <= s1);
    // The eye's distance t and the lamp's r add up to eyeToNearest + h tan(alpha / 2).
    const double integral = sunIntegral(extinctionPerMetre * h, 0.5 * scatteringAngle(h, s0),
                                        0.5 * scatteringAngle(h, s1));
    const double phase = 1.0 / (4.0 * kPi);
    return scatteringPerMetre * phase * 2.0 / h * std::exp(-extinctionPerMetre * eyeToNearest) *
           integral;
}

double gibbonsOverSlab(double h, double s0, double s1, double k) {
    CHECK(h > 0.0 && s0 <= s1);
    // cos^16(alpha / 2) as a Fourier series in alpha, integrated term by term: with da the range of
    // the scattering angle and am its middle, integral of cos(n alpha) = (2 / n) cos(n am) sin(n da
    // / 2).
    constexpr std::array<double, 9> kBinomial16 = {12870.0, 11440.0, 8008.0, 4368.0, 1820.0,
                                                   560.0,   120.0,   16.0,   1.0};
    const double range = std::atan2(h * (s1 - s0), h * h + s0 * s1);
    const double middle = scatteringAngle(h, s0) + 0.5 * range;
    double series = kBinomial16[0] * range;
    for (std::size_t n = 1; n < kBinomial16.size(); ++n) {
        const auto order = double(n);
        series +=
            4.0 / order * kBinomial16[n] * std::cos(order * middle) * std::sin(0.5 * order * range);
    }
    return k / h * (range + 9.0 / 65536.0 * series);
}

}  // namespace ribalta
