// A furnace for single scattering: what a beam loses to thin haze is what all eyes together get.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "base/angles.h"
#include "reference/integrate_beams.h"

namespace ribalta {
namespace {

/// Lumens that a cone lamp of one candela with inner angle 0 loses per unit of scattering
/// coefficient, between the lens plane and its range: the integral of falloff and window over
/// directions and distance.
double lumenMetres(double cosOuter, double range, double lens) {
    constexpr int kSteps = 20000;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double cosine = cosOuter + (1.0 - cosOuter) * (i + 0.5) / kSteps;
        const double ramp = (cosine - cosOuter) / (1.0 - cosOuter);
        const double first = lens / cosine;
        const double distance =
            range - first -
            (std::pow(range, 5.0) - std::pow(first, 5.0)) / (5.0 * std::pow(range, 4.0));
        sum += ramp * ramp * distance * (1.0 - cosOuter) / kSteps;
    }
    return 2.0 * kPi * sum;
}

class Energy : public testing::TestWithParam<PhaseFunction::Kind> {};

// Every straight line through a ball around the beam, equally often: their measure is 4 pi
// directions times the ball's disc. Extinction takes less than 1e-5 on any way.
TEST_P(Energy, WhatTheBeamLosesAllEyesGet) {
    SpotLight lamp;
    lamp.outerConeAngle = 0.7;
    lamp.innerConeAngle = 0.0;
    lamp.rangeMetres = 1.0;
    lamp.frame = lookAt({0.2, -0.1, 0.3}, {1.0, 0.5, -0.4});
    Haze haze;
    haze.scatteringPerMetre = 1e-6;
    haze.phase.kind = GetParam();
    haze.phase.g = 0.5;
    const BeamIntegrator integrator({&lamp, 1}, {}, haze, nullptr);

    const glm::dvec3 centre = lamp.frame.position + 0.5 * lamp.frame.forward();
    const double radius = 0.85;
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    constexpr int kLines = 400000;
    double sum = 0.0;
    for (int i = 0; i < kLines; ++i) {
        const double z = 2.0 * unit(random) - 1.0;
        const double around = 2.0 * kPi * unit(random);
        const double aside = std::sqrt(1.0 - z * z);
        const glm::dvec3 direction(aside * std::cos(around), aside * std::sin(around), z);
        const Frame frame = lookAt({0.0, 0.0, 0.0}, direction);
        const double r = radius * std::sqrt(unit(random));
        const double turn = 2.0 * kPi * unit(random);
        const glm::dvec3 place =
            centre + r * std::cos(turn) * frame.right() + r * std::sin(turn) * frame.up();
        sum += integrator.along({place - 2.0 * direction, direction, 0.0, 4.0}).value.x;
    }
    const double got = sum / kLines * 4.0 * kPi * kPi * radius * radius;
    const double lost = haze.scatteringPerMetre * lumenMetres(std::cos(0.7), 1.0, 0.05);
    // Four times the estimate's standard error, which is 0.4 %.
    EXPECT_NEAR(got / lost, 1.0, 0.016);
}

INSTANTIATE_TEST_SUITE_P(EveryPhaseFunction, Energy,
                         testing::Values(PhaseFunction::Kind::kGibbons,
                                         PhaseFunction::Kind::kHenyeyGreenstein,
                                         PhaseFunction::Kind::kRayleigh));

}  // namespace
}  // namespace ribalta
