// The sky's reference against independent tables of the same model: those of another program, in 22
// digits for single scattering, by random walks for more (support/sky_truth.h).
#include "support/sky_truth.h"

#include <filesystem>
#include <vector>

#include <gtest/gtest.h>

#include "base/parallel_for.h"
#include "reference/integrate_sky.h"

namespace ribalta::test {
namespace {

class SkyTruth : public testing::Test {
  protected:
    void SetUp() override {
        if (!std::filesystem::exists(truthFolder() / "sky.csv")) {
            GTEST_SKIP() << kNoTruth << truthFolder();
        }
        rows_ = readTruth(truthFolder() / "sky.csv");
        for (const TruthRow& row : rows_) {
            rays_.push_back(rayOf(row));
        }
    }

    std::vector<TruthRow> rows_;
    std::vector<SkyRay> rays_;
};

TEST_F(SkyTruth, TransmittanceAndLightScatteredOnce) {
    const SkyIntegrator sky(Atmosphere(), {.orders = 1}, rays_);
    const SkyIntegrator clean(withoutMie(Atmosphere()), {.orders = 1}, rays_);
    SkyErrors transmittance;
    SkyErrors single;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        transmittance.add(rows_[i], "T", sky.transmittanceAlong(rays_[i]));
        transmittance.add(rows_[i], "Tray", clean.transmittanceAlong(rays_[i]));
        const SingleScattering light = sky.singleAlong(rays_[i]);
        single.add(rows_[i], "L1", light.sum());
        single.add(rows_[i], "L1R", light.rayleigh);
        single.add(rows_[i], "L1ray", clean.singleAlong(rays_[i]).sum());
    }
    transmittance.expectBelow("transmittance", {1e-12, 2e-12, 4e-12, 1e-10});
    single.expectBelow("light scattered once", {1e-12, 1e-11, 2e-9, 2e-8});
}

TEST_F(SkyTruth, RaysThatEnd) {
    const SkyIntegrator sky(Atmosphere(), {.orders = 1}, {});
    const SkyIntegrator clean(withoutMie(Atmosphere()), {.orders = 1}, {});
    SkyErrors transmittance;
    SkyErrors single;
    for (const TruthRow& row : readTruth(truthFolder() / "aerial.csv")) {
        const SkyRay ray = rayOf(row);
        transmittance.add(row, "T", sky.transmittanceAlong(ray));
        transmittance.add(row, "Tray", clean.transmittanceAlong(ray));
        single.add(row, "L1", sky.singleAlong(ray).sum());
        single.add(row, "L1ray", clean.singleAlong(ray).sum());
    }
    transmittance.expectBelow("transmittance", {1e-12, 1e-12, 1e-12, 1e-11});
    single.expectBelow("light scattered once", {1e-12, 1e-12, 1e-12, 1e-11});
}

// A quarter of a second a ray: every twentieth.
TEST_F(SkyTruth, LightScatteredTwice) {
    const SkyIntegrator sky(Atmosphere(), {.orders = 2}, {});
    std::vector<std::size_t> some;
    for (std::size_t i = 3; i < rows_.size(); i += 20) {
        some.push_back(i);
    }
    std::vector<glm::dvec3> light(some.size());
    parallelFor(some.size(), [&](std::size_t i) { light[i] = sky.orderAlong(rays_[some[i]], 2); });
    SkyErrors errors;
    for (std::size_t i = 0; i < some.size(); ++i) {
        errors.add(rows_[some[i]], "L2", light[i]);
    }
    // The tables' own precision is 8e-6 of the sum of orders.
    errors.expectBelow("light scattered twice", {1e-6, 1e-5, 3e-5, 1e-4});
}

// By the coarse tables. What is left is mostly the standard error of the truth: 8e-5
// (median), 1.4e-3 (p95), 5e-3 at dusk.
TEST_F(SkyTruth, FourOrdersWithAndWithoutTheGround) {
    SkySettings settings;
    settings.exactSecondOrder = false;
    settings.tables = coarseSkyTables();
    const SkyIntegrator sky(Atmosphere(), settings, rays_);
    std::vector<SkyLight> lights(rays_.size());
    parallelFor(rays_.size(), [&](std::size_t i) { lights[i] = sky.along(rays_[i]); });
    SkyErrors air;
    SkyErrors ground;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        air.add(rows_[i], "Lsum4", lights[i].air);
        ground.add(rows_[i], "Ltot4", lights[i].air + lights[i].ground);
    }
    air.expectBelow("four orders", {2e-4, 1e-3, 2e-3, 1e-2});
    ground.expectBelow("four orders and the ground", {2e-4, 1e-3, 2e-3, 1e-2});
}

TEST_F(SkyTruth, IrradianceOfTheGround) {
    const std::vector<TruthRow> rows = readTruth(truthFolder() / "irradiance.csv");
    std::vector<SkyRay> rays;
    for (const TruthRow& row : rows) {
        const double muS = number(row, "mu_s");
        rays.push_back({0.0, 1.0, muS, muS});
    }
    SkySettings settings;
    settings.orders = 3;
    settings.tables = coarseSkyTables();
    const SkyIntegrator sky(Atmosphere(), settings, rays);
    SkyErrors direct;
    SkyErrors first;
    SkyErrors later;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        direct.add(rows[i], "Edir", sky.irradiance(0, rays[i].muS));
        first.add(rows[i], "E1", sky.irradiance(1, rays[i].muS));
        later.add(rows[i], "E2", sky.irradiance(2, rays[i].muS));
    }
    direct.expectBelow("direct", {1e-12, 1e-12, 1e-12, 1e-11});
    first.expectBelow("of order 1", {1e-8, 1e-6, 3e-6, 1e-5});
    later.expectBelow("of order 2", {1e-3, 1e-2, 2e-2, 5e-2});
}

}  // namespace
}  // namespace ribalta::test
