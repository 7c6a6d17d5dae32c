// Phase functions by what they must be: normalised, with the mean cosine the literature gives.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "optics/shader_lib.h"
#include "quadrature.h"
#include "shader_lib_float.h"

namespace ribalta {
namespace {

constexpr double kGibbonsNormalised = 1.0 / (8.0 * std::numbers::pi);

struct Case {
    int kind;
    double g;
    double meanCosine;
};

double cornetteShanksMean(double g) {
    return 3.0 * g * (4.0 + g * g) / (5.0 * (2.0 + g * g));
}

const Case kCases[] = {
    {shader::kPhaseGibbons, 0.0, 0.4},
    {shader::kPhaseIsotropic, 0.0, 0.0},
    {shader::kPhaseRayleigh, 0.0, 0.0},
    {shader::kPhaseHenyeyGreenstein, 0.0, 0.0},
    {shader::kPhaseHenyeyGreenstein, 0.3, 0.3},
    {shader::kPhaseHenyeyGreenstein, -0.6, -0.6},
    {shader::kPhaseHenyeyGreenstein, 0.9, 0.9},
    {shader::kPhaseHenyeyGreenstein, 0.999, 0.999},
    {shader::kPhaseCornetteShanks, 0.0, 0.0},
    {shader::kPhaseCornetteShanks, 0.5, cornetteShanksMean(0.5)},
    {shader::kPhaseCornetteShanks, -0.8, cornetteShanksMean(-0.8)},
    {shader::kPhaseCornetteShanks, 0.99, cornetteShanksMean(0.99)},
};

TEST(PhaseFunction, IntegratesToOneOverTheSphere) {
    for (const Case& c : kCases) {
        const double integral = integrateSphere(
            [&](double mu) { return shader::phaseFunction(c.kind, mu, c.g, kGibbonsNormalised); });
        EXPECT_NEAR(integral, 1.0, 1e-9) << "kind " << c.kind << ", g " << c.g;
    }
}

TEST(PhaseFunction, HasTheMeanCosineOfTheLiterature) {
    for (const Case& c : kCases) {
        const double mean = integrateSphere([&](double mu) {
            return mu * shader::phaseFunction(c.kind, mu, c.g, kGibbonsNormalised);
        });
        EXPECT_NEAR(mean, c.meanCosine, 1e-9) << "kind " << c.kind << ", g " << c.g;
    }
}

TEST(PhaseFunction, GibbonsIsTheCosineToTheSixteenth) {
    for (double alpha = 0.0; alpha <= std::numbers::pi; alpha += 0.1) {
        const double expected = 20.0 * (1.0 + 9.0 * std::pow(std::cos(0.5 * alpha), 16.0));
        EXPECT_NEAR(shader::phaseGibbons(std::cos(alpha), 20.0), expected, 1e-12 * expected);
    }
}

TEST(PhaseFunction, ForwardIsCosineOne) {
    EXPECT_GT(shader::phaseGibbons(1.0, 1.0), shader::phaseGibbons(-1.0, 1.0));
    EXPECT_GT(shader::phaseHenyeyGreenstein(1.0, 0.5), shader::phaseHenyeyGreenstein(-1.0, 0.5));
    EXPECT_GT(shader::phaseCornetteShanks(1.0, 0.5), shader::phaseCornetteShanks(-1.0, 0.5));
}

TEST(PhaseFunction, SinglePrecisionKeepsThePeak) {
    for (const Case& c : kCases) {
        const auto g = float(c.g);
        const auto k = float(kGibbonsNormalised);
        for (int i = 0; i <= 2000; ++i) {
            const float mu = -1.0F + 0.001F * float(i);
            const double exact = shader::phaseFunction(c.kind, double(mu), double(g), double(k));
            EXPECT_NEAR(shader_float::phaseFunction(c.kind, mu, g, k), exact, 2e-6 * exact)
                << "kind " << c.kind << ", g " << g << ", mu " << mu;
        }
    }
}

TEST(PhaseFunction, IsFiniteAndPositiveForAnyInput) {
    const float wild[] = {-3e38F, -2.0F, -1.0F, -0.0F, 0.0F, 1e-40F, 0.5F, 1.0F, 1.0000001F, 3e38F};
    for (int kind = -1; kind <= 5; ++kind) {
        for (const float mu : wild) {
            for (const float g : wild) {
                const float value = shader_float::phaseFunction(kind, mu, g, 0.04F);
                EXPECT_TRUE(std::isfinite(value) && value > 0.0F)
                    << "kind " << kind << ", mu " << mu << ", g " << g << ": " << value;
            }
        }
    }
}

}  // namespace
}  // namespace ribalta
