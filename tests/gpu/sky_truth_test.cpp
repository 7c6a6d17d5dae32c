// The renderer's own sky against independent tables, at what is promised of it. See
// support/sky_truth.h for the tables.
#include "support/sky_truth.h"

#include "gpu_test.h"
#include "render/evaluate_sky.h"

namespace ribalta::test {
namespace {

class SkyAutoTruth : public GpuTest {
  protected:
    void load(const char* file) {
        rows_ = readTruth(truthFolder() / file);
        for (const TruthRow& row : rows_) {
            rays_.push_back(rayOf(row));
        }
    }
    void SetUp() override {
        if (!std::filesystem::exists(truthFolder() / "sky.csv")) {
            GTEST_SKIP() << kNoTruth << truthFolder();
        }
    }

    std::vector<TruthRow> rows_;
    std::vector<SkyRay> rays_;
};

TEST_F(SkyAutoTruth, LightScatteredOnceAndWhatTheAirLetsThrough) {
    load("sky.csv");
    const std::vector<SkyLight> lights = evaluateSky(Atmosphere{}, {1, false}, rays_);
    SkyErrors once;
    SkyErrors through;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        once.add(rows_[i], "L1", lights[i].air);
        through.add(rows_[i], "T", lights[i].transmittance, 0.0);
    }
    once.expectBelow("once scattered", {2e-4, 2e-3, 6e-3, 5e-2});
    through.expectBelow("transmittance", {1e-4, 3e-3, 3e-3, 3e-3});
}

TEST_F(SkyAutoTruth, FourOrders) {
    load("sky.csv");
    const std::vector<SkyLight> lights = evaluateSky(Atmosphere{}, {4, false}, rays_);
    SkyErrors day;
    SkyErrors dusk;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const bool down = rows_[i].at("group").ends_with("m04");
        (down ? dusk : day).add(rows_[i], "Lsum4", lights[i].air);
    }
    day.expectBelow("four orders, sun up", {5e-3, 1e-2, 2e-2, 5e-2});
    dusk.expectBelow("four orders, sun at -4 degrees", {1e-2, 4e-2, 6e-2, 1e-1});
}

TEST_F(SkyAutoTruth, AirBeforeSurfaces) {
    load("aerial.csv");
    const std::vector<SkyLight> lights = evaluateSky(Atmosphere{}, {1, false}, rays_);
    SkyErrors air;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        air.add(rows_[i], "L1", lights[i].air, 0.0);
        for (int c = 0; c < 3; ++c) {
            EXPECT_GE(lights[i].air[c], 0.0);
        }
    }
    air.expectBelow("air before surfaces", {1e-4, 2e-3, 4e-3, 2e-2});
}

}  // namespace
}  // namespace ribalta::test
