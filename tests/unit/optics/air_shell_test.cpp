// Rays in the shell of air: against plain geometry in long doubles, and in single precision.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "optics/shader_lib.h"
#include "shader_lib_float.h"

namespace ribalta {
namespace {

using Exact = long double;

template <typename Air>
Air earth() {
    Air air{};
    air.groundRadius = 6.36e6F;
    air.top = 60e3F;
    air.rayleighHeight = 8000.0F;
    air.mieHeight = 1200.0F;
    return air;
}

/// A ray within the air, as singles, so that both precisions see the same.
struct AirRay {
    float height;
    float mu;
    float muS;
    float nu;
};

class RandomRays {
  public:
    AirRay next() {
        AirRay ray{};
        // From a millimetre to the top; half of the rays near the horizon.
        ray.height = float(1e-3 * std::pow(6e7, unit_(random_)));
        const double level = -std::sqrt(double(ray.height) / 3.18e6);
        ray.mu = float(unit_(random_) < 0.5 ? 2.0 * unit_(random_) - 1.0
                                            : level + 0.02 * (unit_(random_) - 0.5));
        ray.muS =
            float(unit_(random_) < 0.5 ? 2.0 * unit_(random_) - 1.0 : 0.2 * (unit_(random_) - 0.5));
        const double sines =
            std::sqrt((1.0 - double(ray.mu) * ray.mu) * (1.0 - double(ray.muS) * ray.muS));
        ray.nu =
            float(double(ray.mu) * ray.muS + sines * std::cos(3.14159265358979 * unit_(random_)));
        return ray;
    }
    double unit() { return unit_(random_); }

  private:
    std::mt19937_64 random_{5};
    std::uniform_real_distribution<double> unit_{0.0, 1.0};
};

constexpr Exact kRadius = 6.36e6L;
constexpr Exact kTop = 60e3L;

Exact radiusAt(const AirRay& ray, Exact t) {
    const Exact r = kRadius + ray.height;
    return std::sqrt(r * r + t * (2 * r * Exact(ray.mu) + t));
}

TEST(AirShell, HeightsAndDistancesAreThoseOfPlainGeometry) {
    const auto air = earth<shader::Air>();
    RandomRays rays;
    for (int i = 0; i < 20000; ++i) {
        const AirRay ray = rays.next();
        const bool ground = shader::hitsGround(air, ray.height, ray.mu);
        const double t = shader::distanceInAir(air, ray.height, ray.mu, ground);
        ASSERT_GT(t, 0.0);
        // Where a ray grazes the ground a nanometre of height is centimetres of way.
        EXPECT_NEAR(double(radiusAt(ray, t) - kRadius), ground ? 0.0 : 60e3, 1e-7)
            << ray.height << " " << ray.mu;
        const double part = t * rays.unit();
        const double height = shader::heightAlong(air, ray.height, ray.mu, part);
        EXPECT_NEAR(height, double(radiusAt(ray, part) - kRadius), 1e-8);
        EXPECT_GE(height, shader::lowestHeight(air, ray.height, ray.mu) - 1e-8);
        if (!ground) {
            EXPECT_GE(height, -1e-9);
        }
    }
}

// Forms that subtract squared radii are off by up to 25 m here.
TEST(AirShell, SinglePrecisionKeepsCentimetres) {
    const auto air = earth<shader::Air>();
    const auto single = earth<shader_float::Air>();
    RandomRays rays;
    double worstHeight = 0.0;
    double worstEnd = 0.0;
    int other = 0;
    constexpr int kRays = 200000;
    for (int i = 0; i < kRays; ++i) {
        const AirRay ray = rays.next();
        const bool ground = shader::hitsGround(air, ray.height, ray.mu);
        if (ground != shader_float::hitsGround(single, ray.height, ray.mu)) {
            ++other;
            continue;
        }
        const double t = shader::distanceInAir(air, ray.height, ray.mu, ground);
        const float end = shader_float::distanceInAir(single, ray.height, ray.mu, ground);
        // What counts at the end of a way is how high it is.
        worstEnd = std::max(worstEnd, std::abs(shader::heightAlong(air, ray.height, ray.mu, end) -
                                               (ground ? 0.0 : air.top)));
        const auto part = float(t * rays.unit());
        const double height = shader::heightAlong(air, ray.height, ray.mu, part);
        const float got = shader_float::heightAlong(single, ray.height, ray.mu, part);
        worstHeight = std::max(worstHeight, std::abs(double(got) - height));
    }
    EXPECT_LT(worstHeight, 0.06);
    EXPECT_LT(worstEnd, 0.06);
    // Rays that pass the ground within its last bit.
    EXPECT_LE(other, kRays / 10000);
}

TEST(AirShell, ViewersOnTheGroundAndAtTheTop) {
    for (const double mu : {-1.0, -0.5, -1e-30, 0.0, 1e-30, 0.3, 1.0}) {
        const auto air = earth<shader::Air>();
        const bool ground = shader::hitsGround(air, 0.0, mu);
        EXPECT_EQ(ground, mu < 0.0) << mu;
        EXPECT_GE(shader::distanceInAir(air, 0.0, mu, ground), 0.0);
        const bool fromTop = shader::hitsGround(air, air.top, mu);
        EXPECT_EQ(fromTop, mu <= -0.5);
        const double t = shader::distanceInAir(air, air.top, mu, fromTop);
        EXPECT_TRUE(mu >= 0.0 ? t == 0.0 : t >= 0.0) << mu << ": " << t;
    }
}

TEST(AirShell, TheShadowIsWhereTheGroundHidesTheSun) {
    const auto air = earth<shader::Air>();
    RandomRays rays;
    int shaded = 0;
    for (int i = 0; i < 20000; ++i) {
        const AirRay ray = rays.next();
        const bool ground = shader::hitsGround(air, ray.height, ray.mu);
        const double length = shader::distanceInAir(air, ray.height, ray.mu, ground);
        double entry = 0.0;
        double exit = 0.0;
        const bool some =
            shader::planetShadow(air, ray.height, ray.mu, ray.muS, ray.nu, entry, exit);
        EXPECT_EQ(some, entry < exit);
        const double t = length * rays.unit();
        const double height = shader::heightAlong(air, ray.height, ray.mu, t);
        const double muS = shader::sunCosineAlong(air, ray.height, ray.muS, ray.nu, t, height);
        // The last millimetre may fall on either side.
        if (std::abs(t - entry) > 1e-3 && std::abs(t - exit) > 1e-3 && height > 1e-3) {
            const bool hidden = shader::hitsGround(air, height, muS);
            EXPECT_EQ(hidden, t > entry && t < exit)
                << ray.height << " " << ray.mu << " " << ray.muS << " " << ray.nu << " at " << t;
            shaded += hidden ? 1 : 0;
        }
    }
    EXPECT_GT(shaded, 2000);
}

TEST(AirShell, TheShadowAlongTheSunsOwnLineAndAcrossIt) {
    const auto air = earth<shader::Air>();
    double entry = 0.0;
    double exit = 0.0;
    EXPECT_FALSE(shader::planetShadow(air, 1000.0, 1.0, 1.0, 1.0, entry, exit));
    EXPECT_FALSE(shader::planetShadow(air, 1000.0, -1.0, 1.0, -1.0, entry, exit) && entry < 1000.0);
    EXPECT_TRUE(shader::planetShadow(air, 1000.0, 1.0, -1.0, -1.0, entry, exit));
    EXPECT_EQ(entry, 0.0);
    EXPECT_GT(exit, 1e20);
    // Straight up at dusk: out of the shadow where cos(dip) = R / r.
    const double muS = -0.1;
    EXPECT_TRUE(shader::planetShadow(air, 0.0, 1.0, muS, muS, entry, exit));
    EXPECT_EQ(entry, 0.0);
    EXPECT_NEAR(exit, air.groundRadius * (1.0 / std::sqrt(1.0 - muS * muS) - 1.0), 1e-6);
}

TEST(AirShell, RaysFromSpaceEnterAtTheTop) {
    const auto air = earth<shader::Air>();
    RandomRays rays;
    int entered = 0;
    for (int i = 0; i < 20000; ++i) {
        AirRay ray = rays.next();
        ray.height = float(60e3 * std::pow(200.0, 0.01 + 0.99 * rays.unit()));
        double t = 0.0;
        double mu = 0.0;
        double muS = 0.0;
        const double sine = std::sqrt((1.0 - double(ray.mu)) * (1.0 + double(ray.mu)));
        if (!shader::enterAir(air, ray.height, ray.mu, sine, ray.muS, ray.nu, t, mu, muS)) {
            const Exact r = kRadius + ray.height;
            const Exact lowest = r * std::sqrt(1 - Exact(ray.mu) * ray.mu);
            EXPECT_TRUE(ray.mu >= 0.0F || lowest >= kRadius + kTop - 1e-6L) << ray.mu;
            continue;
        }
        ++entered;
        EXPECT_NEAR(double(radiusAt(ray, t) - kRadius), 60e3, 1e-6);
        const Exact r = kRadius + ray.height;
        EXPECT_NEAR(mu, double((r * ray.mu + t) / (kRadius + kTop)), 1e-9);
        EXPECT_NEAR(muS, double((r * ray.muS + t * ray.nu) / (kRadius + kTop)), 1e-9);
    }
    EXPECT_GT(entered, 2000);
}

// Single precision from four planet's radii away, where the limb is a hundredth of a radian wide.
TEST(AirShell, RaysFromFarAwayAreToldApartByTheirSine) {
    const auto air = earth<shader_float::Air>();
    const float height = 2.5e7F;
    const Exact r = kRadius + Exact(height);
    for (int i = 0; i < 200; ++i) {
        const Exact lowest = kRadius + kTop * Exact(i) / 200;
        const float sine = float(lowest / r);
        const float mu = -float(std::sqrt(1 - (lowest / r) * (lowest / r)));
        float t = 0.0F;
        float muThere = 0.0F;
        float muS = 0.0F;
        ASSERT_TRUE(shader_float::enterAir(air, height, mu, sine, 0.3F, 0.2F, t, muThere, muS));
        const Exact reached = (kRadius + kTop) * std::sqrt(1 - Exact(muThere) * muThere);
        EXPECT_NEAR(double(reached - lowest), 0.0, 5.0) << i;
    }
}

TEST(AirShell, AirIsFiniteAndNeverNegativeForAnyInput) {
    const auto air = earth<shader_float::Air>();
    const float heights[] = {-1.0F, 0.0F, 1e-30F, 1e-3F, 59999.996F, 60e3F, 60e3F + 1.0F};
    const float cosines[] = {-1.0F, -0.9999999F, -0.01F, -1e-20F, 0.0F, 1e-20F, 0.3F, 1.0F};
    for (const float h : heights) {
        for (const float mu : cosines) {
            const bool ground = shader_float::hitsGround(air, h, mu);
            const float t = shader_float::distanceInAir(air, h, mu, ground);
            // A viewer under the ground sees through it.
            EXPECT_TRUE(std::isfinite(t)) << h << " " << mu;
            EXPECT_TRUE(t >= 0.0F || h < 0.0F) << h << " " << mu << ": " << t;
            const float there = shader_float::heightAlong(air, h, mu, t);
            EXPECT_TRUE(std::isfinite(there)) << h << " " << mu;
            EXPECT_LE(std::abs(shader_float::cosineAlong(air, h, mu, t, there)), 1.0F);
            for (const float muS : cosines) {
                for (const float nu : cosines) {
                    float entry = 0.0F;
                    float exit = 0.0F;
                    shader_float::planetShadow(air, h, mu, muS, nu, entry, exit);
                    EXPECT_TRUE(entry >= 0.0F && exit >= entry && std::isfinite(exit))
                        << h << " " << mu << " " << muS << " " << nu << ": " << entry << ".."
                        << exit;
                }
            }
        }
    }
}

}  // namespace
}  // namespace ribalta
