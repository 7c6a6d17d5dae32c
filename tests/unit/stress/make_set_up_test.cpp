// The stress test's generator: cases that can be repeated, that are sound, and that go as far as
// they are said to.
#include "make_set_up.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace ribalta::stress {
namespace {

constexpr int kCases = 4000;
constexpr double kWholeDegrees =
    360.0 / std::numbers::pi;  // whole angle of a half angle in radians

TEST(MakeSetUp, ACaseFollowsFromItsSeedAndNumber) {
    std::set<std::string> seen;
    for (int number = 0; number < 100; ++number) {
        EXPECT_EQ(describe(makeSetUp(5, number)), describe(makeSetUp(5, number)));
        seen.insert(describe(makeSetUp(5, number)));
        seen.insert(describe(makeSetUp(6, number)));
    }
    EXPECT_EQ(seen.size(), 200U);
}

void expectTurn(const glm::dmat3& turn) {
    const glm::dmat3 off = glm::transpose(turn) * turn - glm::dmat3(1.0);
    for (int i = 0; i < 3; ++i) {
        EXPECT_LT(glm::length(off[i]), 1e-12);
    }
}

TEST(MakeSetUp, EveryCaseCanBeDrawn) {
    for (int number = 0; number < kCases; ++number) {
        const stress::SetUp setUp = makeSetUp(1, number);
        SCOPED_TRACE(describe(setUp));
        EXPECT_EQ(setUp.kind, number % int(kindNames().size()));
        EXPECT_GE(setUp.camera.nearMetres, 0.0);
        EXPECT_LT(setUp.camera.nearMetres, setUp.camera.farMetres);
        EXPECT_TRUE(!setUp.camera.isOrthographic() || std::isfinite(setUp.camera.farMetres));
        expectTurn(setUp.camera.frame.worldFromLocal);
        EXPECT_GE(setUp.sheets, 1);
        EXPECT_LE(setUp.sheets, 8192);
        EXPECT_LT(std::abs(setUp.haze.phase.g), 1.0);
        EXPECT_GE(setUp.haze.scatteringPerMetre, 0.0);
        ASSERT_FALSE(setUp.lamps.empty());
        for (const SpotLight& lamp : setUp.lamps) {
            expectTurn(lamp.frame.worldFromLocal);
            EXPECT_LE(lamp.innerConeAngle, lamp.outerConeAngle);
            EXPECT_GE(lamp.intensityCandela, 0.0);
        }
        for (const Rectangle& rectangle : setUp.rectangles) {
            EXPECT_GT(glm::length(glm::cross(rectangle.halfU, rectangle.halfV)), 0.0);
        }
        if (testing::Test::HasFailure()) {
            return;
        }
    }
}

/// The least and the greatest value of something over all cases.
struct Span {
    double low = std::numeric_limits<double>::infinity();
    double high = 0.0;
    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

TEST(MakeSetUp, TheCornersAreReached) {
    Span cone;
    Span distance;
    Span scattering;
    Span candela;
    Span sheets;
    Span fromOrigin;
    for (int number = 0; number < kCases; ++number) {
        const stress::SetUp setUp = makeSetUp(1, number);
        const SpotLight& lamp = setUp.lamps.front();
        cone.add(lamp.outerConeAngle * kWholeDegrees);
        distance.add(glm::length(lamp.frame.position - setUp.camera.frame.position));
        scattering.add(setUp.haze.scatteringPerMetre);
        candela.add(lamp.intensityCandela);
        sheets.add(setUp.sheets);
        fromOrigin.add(glm::length(lamp.frame.position));
    }
    EXPECT_LT(cone.low, 0.12);
    EXPECT_GT(cone.high, 168.0);
    EXPECT_LT(distance.low, 1e-9);  // at the apex itself
    EXPECT_GT(distance.high, 9e4);
    EXPECT_EQ(scattering.low, 0.0);
    EXPECT_GT(scattering.high, 900.0);
    EXPECT_EQ(candela.low, 0.0);
    EXPECT_GE(candela.high, 1e9);
    EXPECT_EQ(sheets.low, 1.0);
    EXPECT_EQ(sheets.high, 8192.0);
    EXPECT_GT(fromOrigin.high, 9e4);
}

TEST(MakeSetUp, MovingKeepsEveryDistance) {
    const stress::SetUp before = makeSetUp(1, 18);  // casters
    ASSERT_FALSE(before.rectangles.empty());
    const glm::dmat3 turn = lookAt({0, 0, 0}, {1, 2, 3}, {0, 1, 0}).worldFromLocal;
    const stress::SetUp after = moved(before, turn, {10.0, -20.0, 30.0});
    const auto gap = [](const stress::SetUp& setUp, const glm::dvec3& point) {
        return glm::length(point - setUp.camera.frame.position);
    };
    EXPECT_NEAR(gap(before, before.lamps[0].frame.position),
                gap(after, after.lamps[0].frame.position), 1e-12);
    const Rectangle& a = before.rectangles[0];
    const Rectangle& b = after.rectangles[0];
    EXPECT_NEAR(gap(before, a.centre + a.halfU), gap(after, b.centre + b.halfU), 1e-12);
    EXPECT_NEAR(glm::dot(before.lamps[0].frame.forward(), before.camera.frame.up()),
                glm::dot(after.lamps[0].frame.forward(), after.camera.frame.up()), 1e-12);
    EXPECT_GT(glm::length(after.camera.frame.position - before.camera.frame.position), 1.0);
}

}  // namespace
}  // namespace ribalta::stress
