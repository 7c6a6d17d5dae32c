// Environments: the light of what stands around a scene, held against integrals over the sphere.
#include "scene/environment.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

namespace ribalta {
namespace {

using std::numbers::pi;

const glm::dmat3 kUnturned(1.0);

// Over all directions, by the midpoint rule in height and angle; exact to some 1e-4 of the whole.
void forEachDirection(const std::function<void(const glm::dvec3&, double solidAngle)>& visit) {
    constexpr int kRows = 400;
    constexpr int kColumns = 400;
    for (int row = 0; row < kRows; ++row) {
        const double z = -1.0 + (row + 0.5) * 2.0 / kRows;
        const double radius = std::sqrt(1.0 - z * z);
        for (int column = 0; column < kColumns; ++column) {
            const double angle = (column + 0.5) * 2.0 * pi / kColumns;
            visit({radius * std::cos(angle), radius * std::sin(angle), z},
                  4.0 * pi / (kRows * kColumns));
        }
    }
}

// The harmonics as their paper has them, number by number.
std::array<double, 9> harmonicsAt(const glm::dvec3& d) {
    return {0.282095,
            0.488603 * d.y,
            0.488603 * d.z,
            0.488603 * d.x,
            1.092548 * d.x * d.y,
            1.092548 * d.y * d.z,
            0.315392 * (3.0 * d.z * d.z - 1.0),
            1.092548 * d.x * d.z,
            0.546274 * (d.x * d.x - d.y * d.y)};
}

using Light = std::function<double(const glm::dvec3& direction)>;

// What falls on a surface, by definition.
double irradianceOn(const glm::dvec3& normal, const Light& luminance) {
    double sum = 0.0;
    forEachDirection([&](const glm::dvec3& d, double solidAngle) {
        sum += luminance(d) * std::max(glm::dot(normal, d), 0.0) * solidAngle;
    });
    return sum;
}

// What a program would write into a file for this light: its luminance projected on the harmonics,
// each band weakened as a cosine weakens it (equations 7 to 9 of the paper).
IrradianceCoefficients coefficientsOf(const Light& luminance) {
    const double band[] = {pi, 2.0 * pi / 3.0, pi / 4.0};
    IrradianceCoefficients coefficients{};
    forEachDirection([&](const glm::dvec3& d, double solidAngle) {
        const std::array<double, 9> harmonics = harmonicsAt(d);
        for (std::size_t i = 0; i < harmonics.size(); ++i) {
            coefficients[i] += glm::dvec3(luminance(d) * harmonics[i] * solidAngle *
                                          band[i == 0  ? 0
                                               : i < 4 ? 1
                                                       : 2]);
        }
    });
    return coefficients;
}

Environment environmentOf(const Light& luminance, const glm::dmat3& rotation = kUnturned) {
    Environment environment;
    environment.lux = irradianceForm(coefficientsOf(luminance), rotation);
    return environment;
}

std::vector<glm::dvec3> someNormals() {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    std::vector<glm::dvec3> list = {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
    for (int i = 0; i < 12; ++i) {
        list.push_back(glm::normalize(glm::dvec3(normal(random), normal(random), normal(random))));
    }
    return list;
}

TEST(EnvironmentTest, EvenLightGivesPiTimesItsLuminance) {
    const Environment even = environmentOf([](const glm::dvec3&) { return 250.0; });
    for (const glm::dvec3& normal : someNormals()) {
        EXPECT_NEAR(irradiance(even, normal).x, 250.0 * pi, 1e-2);
    }
    // And that of the first coefficient alone, by hand.
    IrradianceCoefficients first{};
    first[0] = glm::dvec3(1.0, 2.0, 3.0);
    Environment made;
    made.lux = irradianceForm(first, kUnturned);
    EXPECT_NEAR(irradiance(made, {0, 0, 1}).z, 3.0 / std::sqrt(4.0 * pi), 1e-12);
}

// Light of no more than two bands is held exactly, whatever the normal.
TEST(EnvironmentTest, SmoothLightIsExact) {
    const glm::dvec3 a = glm::normalize(glm::dvec3(0.3, -0.8, 0.5));
    const glm::dvec3 b = glm::normalize(glm::dvec3(-0.6, 0.1, 0.7));
    const Light light = [&](const glm::dvec3& d) {
        return 40.0 + 30.0 * glm::dot(a, d) + 25.0 * glm::dot(a, d) * glm::dot(b, d) +
               10.0 * d.x * d.z;
    };
    const Environment environment = environmentOf(light);
    for (const glm::dvec3& normal : someNormals()) {
        EXPECT_NEAR(irradiance(environment, normal).y, irradianceOn(normal, light), 2e-2);
    }
}

// A cosine lobe has higher bands, too: what is left out is known to stay within some per cent.
TEST(EnvironmentTest, ACosineLobe) {
    const glm::dvec3 towards = glm::normalize(glm::dvec3(0.5, 0.7, -0.2));
    const Light lobe = [&](const glm::dvec3& d) {
        return 100.0 * std::max(glm::dot(towards, d), 0.0);
    };
    const Environment environment = environmentOf(lobe);
    // In the closed form, of a surface that faces it: 100 times the integral of cosine squared.
    const double facing = 100.0 * 2.0 * pi / 3.0;
    EXPECT_NEAR(irradianceOn(towards, lobe), facing, 1e-2);
    EXPECT_NEAR(irradiance(environment, towards).x, facing, 0.02 * facing);
    for (const glm::dvec3& normal : someNormals()) {
        EXPECT_NEAR(irradiance(environment, normal).x, irradianceOn(normal, lobe), 0.04 * facing);
    }
}

TEST(EnvironmentTest, WhatSwingsBelowNothingIsNothing) {
    // A small bright spot: its truncated series is negative behind it.
    const Environment spot =
        environmentOf([](const glm::dvec3& d) { return d.y > 0.99 ? 1e4 : 0.0; });
    double lowest = 1.0;
    for (const glm::dvec3& normal : someNormals()) {
        lowest = std::min(lowest, irradiance(spot, normal).x);
    }
    EXPECT_EQ(lowest, 0.0);
    EXPECT_GT(irradiance(spot, {0, 1, 0}).x, 100.0);
}

TEST(EnvironmentTest, RotationTurnsTheLight) {
    const Light light = [](const glm::dvec3& d) {
        return 50.0 + 40.0 * d.x + 20.0 * d.y * d.z + 5.0 * d.z;
    };
    const Environment plain = environmentOf(light);
    const glm::dquat turn = glm::normalize(glm::dquat(0.4, 0.2, -0.7, 0.5));
    const glm::dmat3 rotation = glm::mat3_cast(turn);
    const Environment turned = environmentOf(light, rotation);
    for (const glm::dvec3& normal : someNormals()) {
        EXPECT_NEAR(irradiance(turned, rotation * normal).x, irradiance(plain, normal).x, 1e-9);
    }
    // A quarter of a turn about y: what came from +x comes from -z.
    const glm::dmat3 quarter = glm::mat3_cast(glm::angleAxis(0.5 * pi, glm::dvec3(0, 1, 0)));
    const Environment fromBack = environmentOf(light, quarter);
    EXPECT_NEAR(irradiance(fromBack, {0, 0, -1}).x, irradiance(plain, {1, 0, 0}).x, 1e-9);
    // Even light stays even.
    const Environment even = environmentOf([](const glm::dvec3&) { return 9.0; }, rotation);
    EXPECT_NEAR(irradiance(even, {0, 1, 0}).x, 9.0 * pi, 1e-3);
}

TEST(EnvironmentTest, OtherAxesSeeTheSame) {
    const Environment environment =
        environmentOf([](const glm::dvec3& d) { return 5.0 + d.x + 2.0 * d.y * d.x; });
    const glm::dmat3 worldFromOther =
        glm::mat3_cast(glm::normalize(glm::dquat(0.1, 0.9, 0.3, -0.2)));
    Environment other;
    for (std::size_t c = 0; c < 3; ++c) {
        other.lux[c] = inOtherAxes(environment.lux[c], worldFromOther);
    }
    for (const glm::dvec3& normal : someNormals()) {
        EXPECT_NEAR(irradiance(other, normal).z, irradiance(environment, worldFromOther * normal).z,
                    1e-12);
    }
}

}  // namespace
}  // namespace ribalta
