// Schuler's sky without tables: its columns against sums along the ray, and both forms' own errors.
#include <cmath>

#include <gtest/gtest.h>

#include "optics/shader_lib.h"
#include "shader_lib_float.h"

namespace ribalta {
namespace {

shader::Air earth() {
    shader::Air air{};
    air.groundRadius = 6.36e6;
    air.top = 60e3;
    air.rayleighHeight = 8000.0;
    air.mieHeight = 1200.0;
    air.rayleighScattering = glm::dvec3(5.8e-6, 13.5e-6, 33.1e-6);
    return air;
}

/// To far above the air, by Simpson's rule.
double summedColumn(const shader::Air& air, double h, double mu) {
    constexpr int kSteps = 200000;
    const double dt = 4e6 / kSteps;
    double sum = 0.0;
    for (int i = 0; i <= kSteps; ++i) {
        const double weight = i == 0 || i == kSteps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
        sum += weight *
               shader::airDensity(shader::heightAlong(air, h, mu, i * dt), air.rayleighHeight);
    }
    return sum * dt / 3.0;
}

TEST(SkyChapman, Columns) {
    const shader::Air air = earth();
    double worstBetter = 0.0;
    double worstSchuler = 0.0;
    for (const double h : {0.0, 2e3, 10e3, 40e3}) {
        const double level = -std::sqrt(shader::airSquare(air, h)) / (air.groundRadius + h);
        for (const double mu : {1.0, 0.5, 0.1, 0.02, 0.0, 0.5 * level, 0.99 * level}) {
            const double right = summedColumn(air, h, mu);
            worstBetter = std::max(worstBetter,
                                   std::abs(shader::chapmanColumn(air, h, mu, true) / right - 1.0));
            worstSchuler = std::max(
                worstSchuler, std::abs(shader::chapmanColumn(air, h, mu, false) / right - 1.0));
        }
    }
    EXPECT_LT(worstBetter, 0.005);
    // As printed it is 3 to 15 % off.
    EXPECT_LT(worstSchuler, 0.16);
    EXPECT_GT(worstSchuler, 0.05);
}

TEST(SkyChapman, AWayIsItsTwoHalves) {
    const shader::Air air = earth();
    for (const bool better : {false, true}) {
        for (const double mu : {-0.9, -0.06, 0.03, 0.9}) {
            const double h = 10e3;
            const bool ground = shader::hitsGround(air, h, mu);
            const double length = shader::distanceInAir(air, h, mu, ground);
            const auto between = [&](double from, double to) {
                const double there = shader::heightAlong(air, h, mu, from);
                const double end = shader::heightAlong(air, h, mu, to);
                return shader::chapmanBetween(
                    air, there, shader::cosineAlong(air, h, mu, from, there), end,
                    shader::cosineAlong(air, h, mu, to, end), ground, better);
            };
            const double whole = between(0.0, length);
            EXPECT_GT(whole, 0.0);
            EXPECT_NEAR(between(0.0, 0.3 * length) + between(0.3 * length, length), whole,
                        1e-6 * whole)
                << mu;
        }
    }
}

TEST(SkyChapman, SinglesNeitherOverflowNorTurnNegative) {
    for (const float height : {100.0F, 8000.0F, 50e3F}) {
        for (const float radius : {4e5F, 6.36e6F}) {
            shader_float::Air air{};
            air.groundRadius = radius;
            air.top = 60e3F;
            air.rayleighHeight = height;
            air.rayleighScattering = glm::vec3(5.8e-6F, 13.5e-6F, 33.1e-6F);
            for (const float h : {0.0F, 1e-3F, 100.0F, 2e3F, 59999.0F, 60e3F}) {
                for (float mu = -1.0F; mu <= 1.0F; mu += 0.004F) {
                    const bool ground = shader_float::hitsGround(air, h, mu);
                    const float length = shader_float::distanceInAir(air, h, mu, ground);
                    for (const float muS : {-1.0F, -0.1F, 0.0F, 0.3F, 1.0F}) {
                        for (const bool better : {false, true}) {
                            const glm::vec3 light = shader_float::chapmanLight(
                                air, h, mu, muS, mu * muS, length, ground, 16, better);
                            EXPECT_TRUE(light.z >= 0.0F && light.z < 1.0F)
                                << height << " " << radius << " " << h << " " << mu << " " << muS;
                        }
                    }
                }
            }
        }
    }
}

}  // namespace
}  // namespace ribalta
