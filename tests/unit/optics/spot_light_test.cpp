// A spot's falloffs by hand-worked values, its light map's orientation by hand-written corners.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "optics/shader_lib.h"
#include "shader_lib_float.h"

namespace ribalta {
namespace {

double cosDegrees(double degrees) {
    return std::cos(degrees * std::numbers::pi / 180.0);
}

TEST(ConeFalloff, FollowsKhrLightsPunctual) {
    const double inner = cosDegrees(20.0);
    const double outer = cosDegrees(30.0);
    EXPECT_EQ(shader::coneFalloff(1.0, inner, outer), 1.0);
    EXPECT_EQ(shader::coneFalloff(inner, inner, outer), 1.0);
    EXPECT_NEAR(shader::coneFalloff(cosDegrees(25.0), inner, outer), 0.2990073, 1e-6);
    EXPECT_EQ(shader::coneFalloff(outer, inner, outer), 0.0);
    EXPECT_EQ(shader::coneFalloff(cosDegrees(30.001), inner, outer), 0.0);
    EXPECT_EQ(shader::coneFalloff(-1.0, inner, outer), 0.0);
}

TEST(ConeFalloff, TightConesAreDimmedAsTheExtensionSays) {
    const double edge = cosDegrees(1.0);
    EXPECT_NEAR(shader::coneFalloff(1.0, edge, edge), 0.0231968, 1e-6);
    EXPECT_EQ(shader::coneFalloff(edge, edge, edge), 0.0);
    EXPECT_EQ(shader_float::coneFalloff(float(edge), float(edge), float(edge)), 0.0F);
    // Where the cones are equal and wide the ramp is 0.001 of cosine.
    EXPECT_EQ(shader::coneFalloff(0.5 + 0.00101, 0.5, 0.5), 1.0);
    EXPECT_NEAR(shader::coneFalloff(0.5005, 0.5, 0.5), 0.25, 1e-10);
}

TEST(RangeWindow, EndsTheLightAtTheRange) {
    EXPECT_EQ(shader::rangeWindow(0.0, 0.1), 1.0);
    EXPECT_NEAR(shader::rangeWindow(5.0, 0.1), 0.9375, 1e-15);
    EXPECT_EQ(shader::rangeWindow(10.0, 0.1), 0.0);
    EXPECT_EQ(shader::rangeWindow(1e9, 0.1), 0.0);
    EXPECT_EQ(shader::rangeWindow(1e9, 0.0), 1.0);
    EXPECT_EQ(shader_float::rangeWindow(3e38F, 0.0F), 1.0F);
}

TEST(InverseSquare, HasOneRuleNearTheLamp) {
    EXPECT_EQ(shader::inverseSquare(2.0), 0.25);
    EXPECT_NEAR(shader::inverseSquare(shader::kLensMetres), 400.0, 1e-10);
    EXPECT_NEAR(shader::inverseSquare(0.0), 400.0, 1e-10);
    EXPECT_EQ(shader_float::inverseSquare(3e38F), 0.0F);
}

void expectUv(double x, double y, double degrees, double u, double v) {
    constexpr double kTanOuter = 0.25;
    const double angle = degrees * std::numbers::pi / 180.0;
    const glm::dvec2 uv = shader::lightMapUv({kTanOuter * x, kTanOuter * y}, 1.0 / kTanOuter,
                                             std::cos(angle), std::sin(angle));
    EXPECT_NEAR(uv.x, u, 1e-12) << x << ", " << y << " turned by " << degrees;
    EXPECT_NEAR(uv.y, v, 1e-12) << x << ", " << y << " turned by " << degrees;
}

TEST(LightMapUv, TopIsUpAndRightIsRightSeenFromTheLamp) {
    expectUv(0.0, 0.0, 0.0, 0.5, 0.5);
    expectUv(1.0, 0.0, 0.0, 1.0, 0.5);
    expectUv(-1.0, 0.0, 0.0, 0.0, 0.5);
    expectUv(0.0, 1.0, 0.0, 0.5, 0.0);
    expectUv(0.0, -1.0, 0.0, 0.5, 1.0);
    expectUv(-0.5, 0.5, 0.0, 0.25, 0.25);
}

TEST(LightMapUv, TurnsCounterClockwiseSeenFromTheLamp) {
    // A quarter turn carries the picture's top to the left, its right to the top.
    expectUv(-1.0, 0.0, 90.0, 0.5, 0.0);
    expectUv(0.0, 1.0, 90.0, 1.0, 0.5);
    expectUv(1.0, 0.0, 90.0, 0.5, 1.0);
    expectUv(0.0, -1.0, 90.0, 0.0, 0.5);
    expectUv(0.0, 1.0, 180.0, 0.5, 1.0);
    // An eighth: the picture's top is at the upper left.
    const double diagonal = std::sqrt(0.5);
    expectUv(-diagonal, diagonal, 45.0, 0.5, 0.0);
}

}  // namespace
}  // namespace ribalta
