// The sky's models of the literature against independent tables: each is as good as is said of it,
// and no better where its own faults are. See support/sky_truth.h for the tables. With
// RIBALTA_SKY_FULL set, precomputed tables have their published sizes (a minute without a GPU).
#include <cstdlib>

#include "gpu_test.h"
#include "render/evaluate_baseline_sky.h"
#include "render/passes/sky_precomputed.h"
#include "support/sky_truth.h"

namespace ribalta::test {
namespace {

bool fullSize() {
    return std::getenv("RIBALTA_SKY_FULL") != nullptr;
}

class SkyBaselineTruth : public GpuTest {
  protected:
    void SetUp() override {
        if (!std::filesystem::exists(truthFolder() / "sky.csv")) {
            GTEST_SKIP() << kNoTruth << truthFolder();
        }
        load("sky.csv");
    }
    void load(const char* file) {
        rows_ = readTruth(truthFolder() / file);
        rays_.clear();
        for (const TruthRow& row : rows_) {
            rays_.push_back(rayOf(row));
        }
    }
    SkyErrors errorsOf(const std::vector<SkyLight>& lights, const char* columns,
                       bool withGround = false) const {
        SkyErrors errors;
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            const glm::dvec3 ground = withGround ? lights[i].ground : glm::dvec3(0.0);
            errors.add(rows_[i], columns, lights[i].air + ground);
        }
        return errors;
    }
    SkyErrors errorsOfTransmittance(const std::vector<SkyLight>& lights,
                                    const char* columns) const {
        SkyErrors errors;
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            errors.add(rows_[i], columns, lights[i].transmittance);
        }
        return errors;
    }
    int negative(const std::vector<SkyLight>& lights) const {
        int count = 0;
        for (const SkyLight& light : lights) {
            for (int c = 0; c < 3; ++c) {
                count += light.air[c] < 0.0 ? 1 : 0;
            }
        }
        return count;
    }

    std::vector<TruthRow> rows_;
    std::vector<SkyRay> rays_;
};

TEST_F(SkyBaselineTruth, Chapman) {
    const std::vector<SkyLight> schuler = evaluateChapmanSky(Atmosphere(), {}, rays_);
    errorsOf(schuler, "L1ray").expectBelow("Schuler", {0.047, 0.19, 0.25, 1.7});
    EXPECT_GT(errorsOf(schuler, "L1ray").quantile(0.5), 0.03);
    const std::vector<SkyLight> better = evaluateChapmanSky(Atmosphere(), {.better = true}, rays_);
    errorsOf(better, "L1ray").expectBelow("the better form", {0.00095, 0.0051, 0.009, 0.13});
    errorsOfTransmittance(better, "Tray")
        .expectBelow("its transmittance", {5e-4, 0.01, 0.02, 0.03});
}

TEST_F(SkyBaselineTruth, Single) {
    PrecomputedSkySettings settings = simplifiedSky();
    settings.scattering = fullSize() ? settings.scattering : SkyVolumeSize{16, 32, 32, 4};
    const PrecomputedSky sky(Atmosphere(), settings);
    const std::vector<SkyLight> lights = evaluatePrecomputedSky(sky, rays_);
    if (fullSize()) {
        errorsOf(lights, "L1").expectBelow("single", {0.0039, 0.074, 0.15, 11.0});
    } else {
        errorsOf(lights, "L1").expectBelow("single, small", {0.013, 0.14, 0.3, 11.0});
    }
    // Its table of transmittance runs across the horizon.
    EXPECT_GT(errorsOfTransmittance(lights, "T").quantile(0.95), 0.2);
    load("aerial.csv");
    EXPECT_EQ(negative(evaluatePrecomputedSky(sky, rays_)), 0);
}

TEST_F(SkyBaselineTruth, BrunetonFourOrders) {
    PrecomputedSkySettings settings;
    settings.scattering = fullSize() ? settings.scattering : SkyVolumeSize{16, 32, 32, 4};
    const PrecomputedSky sky(Atmosphere(), settings);
    const std::vector<SkyLight> lights = evaluatePrecomputedSky(sky, rays_);
    if (fullSize()) {
        errorsOf(lights, "Lsum4").expectBelow("four orders", {0.016, 0.063, 0.095, 0.48});
        errorsOf(lights, "Ltot4", true).expectBelow("with the ground", {0.016, 0.063, 0.095, 0.48});
    } else {
        errorsOf(lights, "Lsum4").expectBelow("four orders, small", {0.03, 0.09, 0.16, 1.2});
        errorsOf(lights, "Ltot4", true)
            .expectBelow("small, with the ground", {0.03, 0.09, 0.16, 1.2});
    }
    errorsOfTransmittance(lights, "T").expectBelow("transmittance", {5e-5, 0.004, 0.02, 0.08});
    // Ends are differences of two look-ups.
    load("aerial.csv");
    EXPECT_GT(negative(evaluatePrecomputedSky(sky, rays_)), 10);
}

TEST_F(SkyBaselineTruth, BrunetonOnceScattered) {
    PrecomputedSkySettings settings;
    settings.orders = 1;
    const PrecomputedSky sky(Atmosphere(), settings);
    errorsOf(evaluatePrecomputedSky(sky, rays_), "L1")
        .expectBelow("once scattered", {0.004, 0.047, 0.095, 1.9});
    load("aerial.csv");
    const std::vector<SkyLight> lights = evaluatePrecomputedSky(sky, rays_);
    errorsOf(lights, "L1").expectBelow("ends, once scattered", {0.018, 0.13, 0.22, 1.2});
    errorsOfTransmittance(lights, "T").expectBelow("their transmittance", {2e-4, 3e-3, 0.01, 0.04});
}

// What is off then is what interpolation loses; in twilight, where that is most, no less.
TEST_F(SkyBaselineTruth, BrunetonOnceScatteredWithExactTexels) {
    PrecomputedSkySettings settings;
    settings.orders = 1;
    settings.exactTexels = true;
    const PrecomputedSky sky(Atmosphere(), settings);
    SkyErrors errors = errorsOf(evaluatePrecomputedSky(sky, rays_), "L1");
    errors.expectBelow("once scattered, exact texels", {0.0023, 0.046, 0.084, 1.9});
    EXPECT_GT(errors.quantile(0.9), 0.03);
}

}  // namespace
}  // namespace ribalta::test
