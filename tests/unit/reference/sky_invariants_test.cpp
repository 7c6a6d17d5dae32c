// The sky's reference by what must be so: closed forms, symmetry and energy.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "base/angles.h"
#include "optics/shader_lib.h"
#include "reference/integrate_sky.h"
#include "sky/optical_length.h"
#include "sky/sky_field.h"
#include "support/strange_airs.h"

namespace ribalta {
namespace {

double relativeTo(const glm::dvec3& right, const glm::dvec3& got) {
    double worst = 0.0;
    for (int c = 0; c < 3; ++c) {
        worst = std::max(worst, std::abs(got[c] - right[c]) / right[c]);
    }
    return worst;
}

TEST(OpticalLength, StraightUpIsTheExponentialsIntegral) {
    const Atmosphere air;
    const glm::dvec2 lengths = opticalLengths(air, 0.0, 1.0, air.topMetres);
    EXPECT_NEAR(lengths.x, 8000.0 * -std::expm1(-60.0 / 8.0), 1e-8);
    EXPECT_NEAR(lengths.y, 1200.0 * -std::expm1(-60.0 / 1.2), 1e-8);
}

// Without a top but 40 scale heights, that is 4e-18 of it.
TEST(OpticalLength, ChapmansFormIsWithinItsBound) {
    Atmosphere air;
    air.topMetres = 320e3;
    for (const double height : {0.0, 2000.0, 20e3}) {
        const double x = (air.groundRadiusMetres + height) / 8000.0;
        for (double mu = -0.01; mu <= 1.0; mu += 0.01) {
            const std::optional<AirPath> path = airPath(air, {height, mu, 1.0, mu});
            if (path->ground) {
                continue;
            }
            const double exact = opticalLengths(air, height, mu, path->length).x / 8000.0;
            EXPECT_NEAR(std::exp(-height / 8000.0) * shader::chapman(x, mu), exact, 0.0034 * exact)
                << height << " m, " << mu;
        }
    }
}

TEST(OpticalLength, TransmittanceMultipliesAlongARay) {
    const Atmosphere air;
    const SkyIntegrator sky(air, {.orders = 1}, {});
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < 300; ++i) {
        const double height = air.topMetres * std::pow(unit(random), 3.0);
        const double mu = 2.0 * unit(random) - 1.0;
        const std::optional<AirPath> path = airPath(air, {height, mu, 1.0, mu});
        const double part = path->length * unit(random);
        const double r = air.groundRadiusMetres + height;
        const double there = std::sqrt(r * r + part * (2.0 * r * mu + part));
        const SkyRay rest{std::max(there - air.groundRadiusMetres, 0.0), (r * mu + part) / there,
                          1.0, (r * mu + part) / there};
        const glm::dvec3 whole = sky.transmittanceAlong({height, mu, 1.0, mu});
        const glm::dvec3 first = sky.transmittanceAlong({height, mu, 1.0, mu, part});
        // A ray that grazes may end elsewhere once its start is rounded.
        if (std::abs(r * r * (1.0 - mu * mu) - std::pow(air.groundRadiusMetres, 2.0)) > 1e7) {
            EXPECT_LT(relativeTo(whole, first * sky.transmittanceAlong(rest)), 1e-7)
                << height << " m, " << mu << ", " << part << " m";
        }
    }
}

TEST(OpticalLength, TheTableKeepsItsWord) {
    for (const double scale : {1.0, 0.125, 4.0}) {
        Atmosphere air;
        air.rayleighScaleHeightMetres *= scale;
        air.mieScaleHeightMetres *= scale;
        const OpticalLengthTable table(air);
        std::mt19937_64 random(4);
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        double worst = 0.0;
        for (int i = 0; i < 3000; ++i) {
            const double height = air.topMetres * std::pow(unit(random), 3.0);
            const double mu = i % 2 == 0 ? unit(random) : 0.1 * unit(random) - 0.05;
            const std::optional<AirPath> path = airPath(air, {height, mu, 1.0, mu});
            if (path->ground) {
                continue;
            }
            const glm::dvec2 exact = opticalLengths(air, height, mu, path->length);
            const glm::dvec2 got = table.toTop(height, mu);
            worst = std::max({worst, std::abs(got.x / exact.x - 1.0),
                              exact.y > 1e-12 ? std::abs(got.y / exact.y - 1.0) : 0.0});
        }
        EXPECT_LT(worst, scale < 1.0 ? 5e-4 : 5e-6) << scale;
    }
}

// Thin air over a ray: what is scattered is the integral of density alone.
TEST(Sky, ThinAirScattersItsOpticalLength) {
    Atmosphere air;
    air.rayleighScatteringPerMetre *= 1e-9;
    air.mieScatteringPerMetre *= 1e-9;
    air.mieExtinctionPerMetre *= 1e-9;
    const SkyIntegrator sky(air, {.orders = 1}, {});
    for (const double mu : {0.0, 0.1, 0.5, 1.0}) {
        const double nu = 0.6 * mu;
        const SkyRay ray{0.0, mu, 0.6, nu};
        const std::optional<AirPath> path = airPath(air, ray);
        const glm::dvec2 lengths = opticalLengths(air, 0.0, mu, path->length);
        const SingleScattering light = sky.singleAlong(ray);
        EXPECT_LT(relativeTo(air.rayleighScatteringPerMetre * lengths.x * shader::phaseRayleigh(nu),
                             light.rayleigh),
                  1e-7);
        EXPECT_LT(relativeTo(air.mieScatteringPerMetre * lengths.y *
                                 shader::phaseCornetteShanks(nu, air.mieG),
                             light.mie),
                  1e-7);
    }
}

// Straight up under the sun in the zenith both ways hold the same air, which integrates in closed
// form: phase / 2 (1 - exp(-2 tau)) downwards, phase tau exp(-tau) upwards.
TEST(Sky, SunInTheZenithHasClosedForms) {
    const Atmosphere air = withoutMie(Atmosphere());
    const SkyIntegrator sky(air, {.orders = 1}, {});
    const double length = 8000.0 * -std::expm1(-60.0 / 8.0);
    const glm::dvec3 tau = air.rayleighScatteringPerMetre * length;
    const glm::dvec3 up = sky.singleAlong({0.0, 1.0, 1.0, 1.0}).sum();
    EXPECT_LT(relativeTo(shader::phaseRayleigh(1.0) * tau * glm::exp(-tau), up), 1e-10);
    const glm::dvec3 down = sky.singleAlong({air.topMetres, -1.0, 1.0, -1.0}).sum();
    EXPECT_LT(relativeTo(shader::phaseRayleigh(-1.0) * 0.5 * (1.0 - glm::exp(-2.0 * tau)), down),
              1e-10);
    // From space the same, and of the ground what the air leaves on both ways.
    const SkyLight seen = sky.along({5e6, -1.0, 1.0, -1.0});
    EXPECT_LT(relativeTo(down, seen.air), 1e-10);
    EXPECT_LT(relativeTo(air.groundAlbedo / kPi * glm::exp(-2.0 * tau), seen.ground), 1e-6);
}

TEST(Sky, RaysThatMissTheAirOrEndBeforeItBringNothing) {
    const SkyIntegrator sky(Atmosphere(), {.orders = 1}, {});
    for (const SkyRay& ray : {SkyRay{400e3, 0.5, 1.0, 0.5}, SkyRay{400e3, -0.1, 1.0, -0.1},
                              SkyRay{400e3, -1.0, 1.0, -1.0, 339e3}, SkyRay{60e3, 0.2, 1.0, 0.2},
                              SkyRay{100.0, 0.2, 1.0, 0.2, 0.0}}) {
        const SkyLight light = sky.along(ray);
        EXPECT_EQ(light.transmittance, glm::dvec3(1.0));
        EXPECT_EQ(light.air, glm::dvec3(0.0));
        EXPECT_EQ(light.ground, glm::dvec3(0.0));
    }
}

TEST(Sky, SegmentsAddUp) {
    const SkyIntegrator sky(Atmosphere(), {.orders = 1}, {});
    const SkyRay whole{2000.0, -0.01, 0.1, 0.3, 90e3};
    SkyRay first = whole;
    first.distanceMetres = 30e3;
    const double r = Atmosphere().groundRadiusMetres + whole.heightMetres;
    const double t = first.distanceMetres;
    const double there = std::sqrt(r * r + t * (2.0 * r * whole.mu + t));
    const SkyRay rest{there - Atmosphere().groundRadiusMetres, (r * whole.mu + t) / there,
                      (r * whole.muS + t * whole.nu) / there, whole.nu, whole.distanceMetres - t};
    const glm::dvec3 sum =
        sky.singleAlong(first).sum() + sky.transmittanceAlong(first) * sky.singleAlong(rest).sum();
    EXPECT_LT(relativeTo(sky.singleAlong(whole).sum(), sum), 1e-8);
}

// Light goes both ways alike: what the air sends from one direction into another is the same with
// sun and eye exchanged, above the air and where the ground is black and, all but, flat.
TEST(Sky, SunAndEyeMayBeExchanged) {
    Atmosphere flat;
    flat.groundRadiusMetres = 1e9;
    const SkyIntegrator sky(flat, {.orders = 2, .groundLightsAir = false}, {});
    const double a = 0.8;
    const double b = 0.35;
    const double cosine = -a * b + std::sqrt((1.0 - a * a) * (1.0 - b * b)) * std::cos(0.7);
    for (const int order : {1, 2}) {
        const glm::dvec3 one = sky.orderAlong({flat.topMetres, -a, b, cosine}, order) * a;
        const glm::dvec3 other = sky.orderAlong({flat.topMetres, -b, a, cosine}, order) * b;
        EXPECT_LT(relativeTo(one, other), 1e-3) << order;
    }
}

// Over a white ground, in air that absorbs nothing, what comes in goes out again.
TEST(Sky, WhatComesInGoesOut) {
    Atmosphere air;
    air.groundRadiusMetres = 1e8;  // flat enough that the horizon takes nothing along
    air.topMetres = 40e3;
    air.groundAlbedo = glm::dvec3(1.0);
    const double muS = 0.6;
    air.rayleighScatteringPerMetre *= 0.25;  // few orders are left then
    air.mieScatteringPerMetre *= 0.25;
    air.mieExtinctionPerMetre = air.mieScatteringPerMetre;
    SkySettings settings;
    settings.orders = 7;
    settings.exactSecondOrder = false;
    settings.tables = coarseSkyTables();
    const SkyDirections directions = directionsAt(air, air.topMetres, {4, 16, 9});
    std::vector<SkyRay> rays;
    std::vector<double> weights;
    for (std::size_t i = 0; i < directions.mu.size(); ++i) {
        for (std::size_t j = 0; directions.mu[i] < 0.0 && j < directions.cosAzimuths.size(); ++j) {
            const AirPath path = airPathTowards(air, air.topMetres, directions.mu[i], muS,
                                                directions.cosAzimuths[j]);
            rays.push_back({air.topMetres, path.mu, muS, path.nu});
            weights.push_back(-path.mu * directions.weights[i] * directions.azimuthWeights[j]);
        }
    }
    const SkyIntegrator sky(air, settings, rays);
    glm::dvec3 out(0.0);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const SkyLight light = sky.along(rays[i]);
        out += weights[i] * (light.air + light.ground);
    }
    const glm::dvec3 part = out / muS;
    EXPECT_NEAR(part.x, 1.0, 2e-3);
    EXPECT_NEAR(part.y, 1.0, 2e-3);
    EXPECT_NEAR(part.z, 1.0, 2e-3);
}

// Viewers at both ends of the air and beyond, suns around the horizon, in air of all kinds.
TEST(Sky, ExtremesAreFiniteAndNotNegative) {
    std::vector<SkyRay> rays;
    for (const double height : {0.0, 1e-3, 1000.0, 60e3 - 1e-6, 60e3, 400e3}) {
        for (const double mu : {-1.0, -0.3, -1e-3, 0.0, 1e-12, 1.0}) {
            for (const double muS : {-1.0, -0.07, -1e-4, 0.0, 1e-4, 1.0}) {
                const double sines = std::sqrt((1.0 - mu * mu) * (1.0 - muS * muS));
                rays.push_back({height, mu, muS, mu * muS + sines});
            }
        }
    }
    for (const Atmosphere& air : test::strangeAirs()) {
        SkySettings settings;
        settings.orders = 2;
        settings.exactSecondOrder = false;
        settings.tables = coarseSkyTables();
        settings.tables.heights = 8;
        const SkyIntegrator sky(air, settings, rays);
        for (const SkyRay& ray : rays) {
            const SkyLight light = sky.along(ray);
            for (const glm::dvec3& value : {light.transmittance, light.air, light.ground}) {
                for (int c = 0; c < 3; ++c) {
                    EXPECT_TRUE(std::isfinite(value[c]) && value[c] >= 0.0)
                        << ray.heightMetres << " m, mu " << ray.mu << ", sun " << ray.muS << ": "
                        << value[c];
                }
            }
        }
    }
}

}  // namespace
}  // namespace ribalta
