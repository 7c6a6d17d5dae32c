// Adaptive integration against integrals known by hand, with peaks and kinks.
#include "reference/adaptive_integral.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace ribalta {
namespace {

const std::vector<Interval> kUnit = {{0.0, 1.0}};

TEST(AdaptiveIntegral, IsExactForPolynomials) {
    const Integral result = integrateAdaptively(
        [](double x) { return glm::dvec3(1.0, x * x, 14.0 * std::pow(x, 13.0)); }, kUnit);
    EXPECT_NEAR(result.value.x, 1.0, 1e-14);
    EXPECT_NEAR(result.value.y, 1.0 / 3.0, 1e-14);
    EXPECT_NEAR(result.value.z, 1.0, 1e-14);
    EXPECT_LT(result.error, 1e-14);
    EXPECT_EQ(result.evaluations, 8 * 15);
}

TEST(AdaptiveIntegral, RefinesPeaksUntilItsErrorIsSmallEnough) {
    // A peak of width 1e-4 that the first pieces hardly see.
    const double width = 1e-4;
    const auto peak = [&](double x) {
        return glm::dvec3(width / ((x - 0.37) * (x - 0.37) + width * width));
    };
    const double exact = std::atan(0.63 / width) + std::atan(0.37 / width);
    const Integral result = integrateAdaptively(peak, kUnit);
    EXPECT_NEAR(result.value.x, exact, 1e-6 * exact);
    EXPECT_LE(result.error, 1e-6 * exact * 1.000001);
}

TEST(AdaptiveIntegral, FindsKinksByItself) {
    const auto kink = [](double x) { return glm::dvec3(std::abs(x - 0.3141592)); };
    const double exact = 0.5 * (0.3141592 * 0.3141592 + 0.6858408 * 0.6858408);
    const Integral result = integrateAdaptively(kink, kUnit, {.relative = 1e-10, .absolute = 0.0});
    EXPECT_NEAR(result.value.x, exact, 1e-10);
}

TEST(AdaptiveIntegral, NothingIsNothing) {
    const Interval point[] = {{0.5, 0.5}};
    for (const std::span<const Interval> stretches : {std::span<const Interval>(), {point, 1}}) {
        const Integral result =
            integrateAdaptively([](double) { return glm::dvec3(1.0); }, stretches);
        EXPECT_EQ(result.value, glm::dvec3(0.0));
        EXPECT_EQ(result.evaluations, 0);
    }
}

TEST(AdaptiveIntegral, KinksOnTheEndsOfStretchesCostNothing) {
    const Interval stretches[] = {{0.0, 0.3}, {0.3, 0.5}, {0.75, 1.0}};
    const auto kink = [](double x) { return glm::dvec3(std::max(0.0, x - 0.3)); };
    const Integral result = integrateAdaptively(kink, stretches, {.relative = 1e-12});
    EXPECT_NEAR(result.value.x, 0.02 + 0.5 * (0.49 - 0.2025), 1e-14);
    EXPECT_LE(result.evaluations, 15 * 11);
}

TEST(AdaptiveIntegral, SaysSoWhereItGaveUp) {
    const auto wild = [](double x) { return glm::dvec3(1.0 + std::sin(1.0 / (x + 1e-6))); };
    const Integral result = integrateAdaptively(wild, kUnit, {.relative = 1e-13, .maxPieces = 20});
    EXPECT_GT(result.error, 1e-6);
}

}  // namespace
}  // namespace ribalta
