// The sky's models of the literature on the GPU: against the reference, each with its own faults;
// at extremes of air, eye and sun; what their tables take.
#include <array>
#include <cmath>
#include <cstddef>
#include <random>

#include <shared/sky_precomputed.h>
#include <shared/slots.h>

#include "base/angles.h"
#include "gl/counters.h"
#include "gl/program.h"
#include "gpu_test.h"
#include "reference/integrate_sky.h"
#include "render/evaluate_baseline_sky.h"
#include "render/passes/sky_precomputed.h"
#include "support/sky_truth.h"
#include "support/strange_airs.h"

namespace ribalta::test {
namespace {

SkyRay rayTowards(double height, double mu, double elevation, double cosAzimuth) {
    const double muS = std::sin(elevation * kDegree);
    const double sines = std::sqrt((1.0 - mu * mu) * (1.0 - muS * muS));
    return {height, mu, muS, mu * muS + sines * cosAzimuth};
}

/// Suns from 3 degrees up, not within a degree of the horizon. Tables tell the lowest 60 m from
/// nothing else, where a way down holds next to no light.
std::vector<SkyRay> plainRays(int count) {
    std::mt19937 engine(4);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine);
    };
    std::vector<SkyRay> rays;
    while (int(rays.size()) < count) {
        const double height = 200.0 + 5e4 * std::pow(between(0.0, 1.0), 2.0);
        const double mu = between(-1.0, 1.0);
        const double level = -std::sqrt(2.0 * height / 6.4e6);
        if (std::abs(mu - level) > 0.02) {
            rays.push_back(rayTowards(height, mu, between(3.0, 90.0), between(-1.0, 1.0)));
        }
    }
    return rays;
}

PrecomputedSkySettings smallTables(bool simplified, int orders) {
    PrecomputedSkySettings settings = simplified ? simplifiedSky() : PrecomputedSkySettings{};
    settings.orders = orders;
    settings.scattering = {8, 16, 16, 4};
    settings.irradiance = {16, 4};
    return settings;
}

class SkyBaseline : public GpuTest {};

TEST_F(SkyBaseline, OnceScatteredIsAboutTheReferences) {
    const std::vector<SkyRay> rays = plainRays(300);
    const SkyIntegrator exact(Atmosphere(), {.orders = 1}, rays);
    const SkyIntegrator clean(withoutMie(Atmosphere()), {.orders = 1}, rays);
    PrecomputedSkySettings settings;
    settings.orders = 1;
    settings.scattering = {32, 64, 32, 8};
    PrecomputedSkySettings simplified = simplifiedSky();
    simplified.scattering = {16, 32, 64, 4};
    const std::array<std::vector<SkyLight>, 4> lights = {
        evaluatePrecomputedSky(PrecomputedSky(Atmosphere(), settings), rays),
        evaluatePrecomputedSky(PrecomputedSky(Atmosphere(), simplified), rays),
        evaluateChapmanSky(Atmosphere(), {}, rays),
        evaluateChapmanSky(Atmosphere(), {.better = true}, rays)};
    std::array<SkyErrors, 4> air;
    std::array<SkyErrors, 4> ground;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const SkyLight right = exact.along(rays[i]);
        const SkyLight rightClean = clean.along(rays[i]);
        for (std::size_t m = 0; m < lights.size(); ++m) {
            const SkyLight& one = m < 2 ? right : rightClean;
            air[m].add(one.air, lights[m][i].air);
            ground[m].add(one.ground, lights[m][i].ground);
        }
    }
    air[0].expectBelow("bruneton", {0.005, 0.02, 0.03, 0.2});
    air[1].expectBelow("single", {0.015, 0.06, 0.08, 0.3});
    air[2].expectBelow("chapman", {0.01, 0.06, 0.12, 1.2});
    air[3].expectBelow("chapman, better", {0.001, 0.003, 0.006, 0.02});
    EXPECT_GT(air[2].quantile(0.9), 0.03);
    ground[0].expectBelow("bruneton's ground", {1e-4, 5e-4, 1e-3, 5e-3});
    ground[1].expectBelow("single's ground", {0.001, 0.01, 0.02, 0.05});
    ground[2].expectBelow("chapman's ground", {0.03, 0.16, 0.3, 1.2});
    ground[3].expectBelow("chapman's ground, better", {0.001, 0.004, 0.01, 0.03});
}

// Divided by Rayleigh's phase function, as it is kept, light scattered more than once follows that
// function: too much towards a high sun and away from it, too little across.
TEST_F(SkyBaseline, MoreOrdersAreMoreLightAndKeepTheirFault) {
    const std::vector<SkyRay> rays = {rayTowards(0.0, 0.8, 53.0, 1.0),
                                      rayTowards(0.0, 0.7, 15.0, 0.0)};
    SkySettings exactSettings;
    exactSettings.orders = 3;
    exactSettings.tables = coarseSkyTables();
    exactSettings.exactSecondOrder = false;
    const SkyIntegrator exact(Atmosphere(), exactSettings, rays);
    std::array<std::vector<SkyLight>, 4> lights;
    for (int orders = 1; orders <= 3; ++orders) {
        PrecomputedSkySettings settings = smallTables(false, orders);
        settings.scattering = {8, 24, 16, 4};
        settings.halfFloats = false;
        lights[std::size_t(orders)] =
            evaluatePrecomputedSky(PrecomputedSky(Atmosphere(), settings), rays);
    }
    for (std::size_t i = 0; i < rays.size(); ++i) {
        for (std::size_t order = 2; order <= 3; ++order) {
            const double ratio = (lights[order][i].air.z - lights[order - 1][i].air.z) /
                                 exact.orderAlong(rays[i], int(order)).z;
            EXPECT_GT(ratio, 0.75);
            EXPECT_LT(ratio, 1.35);
            if (order == 2 && i == 0) {
                EXPECT_GT(ratio, 1.05);
            }
        }
    }
}

TEST_F(SkyBaseline, HalvesAndSinglesAgree) {
    const std::vector<SkyRay> rays = plainRays(100);
    PrecomputedSkySettings settings = smallTables(false, 2);
    const std::vector<SkyLight> half =
        evaluatePrecomputedSky(PrecomputedSky(Atmosphere(), settings), rays);
    settings.halfFloats = false;
    const std::vector<SkyLight> single =
        evaluatePrecomputedSky(PrecomputedSky(Atmosphere(), settings), rays);
    SkyErrors errors;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        errors.add(single[i].air, half[i].air);
    }
    errors.expectBelow("halves against singles", {5e-3, 2e-2, 3e-2, 6e-2});
    EXPECT_GT(errors.quantile(0.5), 0.0);
}

/// Heights from the ground to space, rays up, down and past the horizon, suns from nadir to zenith.
std::vector<SkyRay> extremeRays(const Atmosphere& air) {
    const double top = air.topMetres;
    std::vector<SkyRay> rays;
    for (const double height :
         {0.0, 1e-3, 2.0, 0.5 * top, top - 1e-3, top, top + 1e-3, 7.0 * top, 200.0 * top}) {
        const double ground = air.groundRadiusMetres;
        const double horizon = -std::sqrt(height * (2.0 * ground + height)) / (ground + height);
        const double reach = std::min((ground + top) / (ground + height), 1.0);
        const double limb = -std::sqrt(1.0 - reach * reach);
        for (const double mu :
             {-1.0, 0.5 * (horizon - 1.0), horizon - 1e-6, horizon, std::min(horizon + 1e-6, 1.0),
              0.5 * (horizon + limb), limb, 0.0, 1e-4, 0.5, 1.0}) {
            for (double elevation = -90.0; elevation <= 90.0; elevation += 7.5) {
                rays.push_back(rayTowards(height, mu, elevation, 1.0));
                rays.push_back(rayTowards(height, mu, elevation, -0.3));
            }
            for (int step = -20; step <= 20; ++step) {
                rays.push_back(rayTowards(height, mu, 0.01 * step, 0.7));
            }
        }
    }
    return rays;
}

void expectSane(const char* what, const std::vector<SkyRay>& rays,
                const std::vector<SkyLight>& lights) {
    int bad = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const bool sane = lights[i].transmittance[c] >= 0.0 &&
                              lights[i].transmittance[c] <= 1.0001 && lights[i].air[c] >= 0.0 &&
                              lights[i].air[c] < 100.0 && lights[i].ground[c] >= 0.0 &&
                              lights[i].ground[c] < 1.0;
            if (!sane && bad++ < 5) {
                ADD_FAILURE() << what << ": height " << rays[i].heightMetres << ", mu "
                              << rays[i].mu << ", muS " << rays[i].muS << ", nu " << rays[i].nu
                              << ": T " << lights[i].transmittance[c] << ", air "
                              << lights[i].air[c] << ", ground " << lights[i].ground[c];
            }
        }
    }
    EXPECT_EQ(bad, 0) << what;
}

TEST_F(SkyBaseline, ExtremesOfAirEyeAndSun) {
    std::vector<Atmosphere> airs = strangeAirs();
    airs.emplace_back();
    for (const Atmosphere& air : airs) {
        const std::vector<SkyRay> rays = extremeRays(air);
        for (const bool half : {true, false}) {
            PrecomputedSkySettings settings = smallTables(false, half ? 3 : 1);
            settings.scattering = {4, 8, 16, 2};
            settings.halfFloats = half;
            expectSane("bruneton", rays,
                       evaluatePrecomputedSky(PrecomputedSky(air, settings), rays));
            settings = smallTables(true, 1);
            settings.halfFloats = half;
            settings.exactTexels = half;
            expectSane("single", rays, evaluatePrecomputedSky(PrecomputedSky(air, settings), rays));
            expectSane("chapman", rays, evaluateChapmanSky(air, {half, 16}, rays));
        }
    }
}

TEST_F(SkyBaseline, RaysThatEndAndRaysThatMiss) {
    const PrecomputedSky sky(Atmosphere(), smallTables(false, 1));
    const SkyRay endless = rayTowards(2e3, 0.3, 20.0, 0.5);
    SkyRay none = endless;
    none.distanceMetres = 0.0;
    SkyRay some = endless;
    some.distanceMetres = 20e3;
    SkyRay past = endless;
    past.distanceMetres = 1e7;
    const SkyRay miss = rayTowards(400e3, 0.2, 20.0, 0.5);
    const std::vector<SkyRay> rays = {endless, none, some, past, miss};
    for (const std::vector<SkyLight>& lights :
         {evaluatePrecomputedSky(sky, rays), evaluateChapmanSky(Atmosphere(), {}, rays)}) {
        EXPECT_NEAR(lights[1].air.z, 0.0, 1e-6);
        EXPECT_NEAR(lights[1].transmittance.z, 1.0, 1e-6);
        EXPECT_GT(lights[2].air.z, 0.2 * lights[0].air.z);
        EXPECT_LT(lights[2].air.z, lights[0].air.z);
        EXPECT_GT(lights[2].transmittance.z, lights[0].transmittance.z);
        EXPECT_EQ(lights[3].air.z, lights[0].air.z);
        EXPECT_EQ(lights[4].air.z, 0.0);
        EXPECT_EQ(lights[4].transmittance.z, 1.0);
    }
}

TEST_F(SkyBaseline, SizesLieAsTheShadersHaveThem) {
    const Program program({"passes/sky_precomputed_points.comp"});
    const auto property = [&](GLenum interface, const char* name, GLenum what) {
        const GLuint index = glGetProgramResourceIndex(program.name(), interface, name);
        GLint value = -1;
        glGetProgramResourceiv(program.name(), interface, index, 1, &what, 1, nullptr, &value);
        return value;
    };
    EXPECT_EQ(property(GL_UNIFORM_BLOCK, "PrecomputedSkyBlock", GL_BUFFER_DATA_SIZE),
              GLint(sizeof(gpu::PrecomputedSky)));
    EXPECT_EQ(property(GL_UNIFORM_BLOCK, "PrecomputedSkyBlock", GL_BUFFER_BINDING),
              gpu::kPrecomputedSkySlot);
    EXPECT_EQ(property(GL_UNIFORM, "tables.scattering", GL_OFFSET),
              GLint(offsetof(gpu::PrecomputedSky, scattering)));
    EXPECT_EQ(property(GL_UNIFORM, "tables.suns", GL_OFFSET),
              GLint(offsetof(gpu::PrecomputedSky, suns)));
}

TEST_F(SkyBaseline, SaysWhatItTakes) {
    const std::uint64_t before = glCounters().bytesAllocated;
    for (const int orders : {1, 2}) {
        const PrecomputedSky sky(Atmosphere(), smallTables(false, orders));
        const std::uint64_t plane = 16 * (256 * 64 + 16 * 4);
        const std::uint64_t volume = std::uint64_t(8) * 8 * 16 * 16 * 4;
        EXPECT_EQ(sky.cost().keptBytes, plane + 2 * volume);
        EXPECT_EQ(sky.cost().peakBytes, plane + 16 * 16 * 4 + (orders == 1 ? 2 : 4) * volume);
        // Uniform blocks are not counted as tables.
        EXPECT_NEAR(double(glCounters().bytesAllocated - before), double(sky.cost().keptBytes),
                    1024.0);
        EXPECT_GT(sky.cost().dispatches, 8 * orders);
        EXPECT_GT(sky.cost().cpuSeconds, 0.0);
        EXPECT_GT(sky.cost().gpuSeconds, 0.0);
        EXPECT_GE(sky.cost().wallSeconds, sky.cost().gpuSeconds);
    }
    EXPECT_EQ(glCounters().bytesAllocated, before);
}

}  // namespace
}  // namespace ribalta::test
