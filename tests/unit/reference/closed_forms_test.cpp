// The closed forms against a plain sum of the integrand they stand for.
#include "reference/closed_forms.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/angles.h"

namespace ribalta {
namespace {

/// Simpson's rule with many steps.
template <typename Function>
double sum(const Function& f, double a, double b) {
    constexpr int kSteps = 200000;
    const double step = (b - a) / kSteps;
    double total = f(a) + f(b);
    for (int i = 1; i < kSteps; ++i) {
        total += (i % 2 == 1 ? 4.0 : 2.0) * f(a + step * i);
    }
    return total * step / 3.0;
}

struct Segment {
    double h;
    double eyeToNearest;
    double s0;
    double s1;
};

const Segment kSegments[] = {
    {1.0, 5.0, -5.0, 5.0},   {0.2, 3.0, -1.0, 0.5}, {2.0, -1.0, 1.0, 30.0},
    {0.05, 4.0, -4.0, -0.1}, {10.0, 0.0, 0.0, 1.0},
};

TEST(ClosedForms, IsotropicPointSourceIsTheIntegral) {
    const double scattering = 0.04;
    for (const Segment& g : kSegments) {
        for (const double extinction : {0.0, 0.05, 0.7}) {
            const auto integrand = [&](double s) {
                const double square = g.h * g.h + s * s;
                const double path = std::sqrt(square) + g.eyeToNearest + s;
                return scattering / (4.0 * kPi) * std::exp(-extinction * path) / square;
            };
            const double exact = sum(integrand, g.s0, g.s1);
            EXPECT_NEAR(
                isotropicPointSource(g.h, g.eyeToNearest, g.s0, g.s1, scattering, extinction),
                exact, 1e-11 * exact)
                << "h " << g.h << ", extinction " << extinction;
        }
    }
}

TEST(ClosedForms, IsotropicPointSourceOverAWholeLineWithoutExtinction) {
    // The integral of 1 / (h^2 + s^2) over all s is pi / h.
    EXPECT_NEAR(isotropicPointSource(0.5, 0.0, -1e9, 1e9, 1.0, 0.0), 0.5, 1e-8);
}

TEST(ClosedForms, GibbonsOverSlabIsTheIntegral) {
    for (const Segment& g : kSegments) {
        const auto integrand = [&](double s) {
            const double square = g.h * g.h + s * s;
            const double alpha = std::acos(-s / std::sqrt(square));
            return (1.0 + 9.0 * std::pow(std::cos(0.5 * alpha), 16.0)) / (8.0 * kPi) / square;
        };
        const double exact = sum(integrand, g.s0, g.s1);
        EXPECT_NEAR(gibbonsOverSlab(g.h, g.s0, g.s1, 1.0 / (8.0 * kPi)), exact, 1e-10 * exact)
            << "h " << g.h;
    }
}

}  // namespace
}  // namespace ribalta
