// The error from a sample of pixels against the same from all of them.
#include "measure/error_estimate.h"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "gpu_test.h"
#include "measure/display_picture.h"
#include "measure/drawn_frame.h"
#include "measure/measure_point.h"
#include "measure/picture_error.h"
#include "support/stage.h"

namespace ribalta::test {
namespace {

using std::chrono::milliseconds;

class ErrorEstimateTest : public GpuTest {
  protected:
    Scene scene_ = makeScene();
    Camera camera_ = makeCamera({0.5, 2, 8}, {0, 2, 0});
    FrameSettings settings_;
    Renderer renderer_{scene_};
    double ev100_ = 0.0;

    static Scene makeScene() {
        Scene scene;
        addShape(scene, makeQuad({0, 0, 0}, {5, 0, 0}, {0, 0, -5}), makeMaterial(glm::vec3(0.5F)));
        addShape(scene, makeSphere({0.2F, 2, 0}, 0.5F, 16), makeMaterial(glm::vec3(0.5F)));
        scene.spotLights.push_back(makeSpot({0, 5, 0}, {0, 0, 0}, 0.3));
        return scene;
    }

    ErrorEstimateTest() {
        settings_.width = 96;
        settings_.height = 54;
        settings_.beams.method = BeamMethod::kClipped;
        settings_.beams.planes = 3;
        ev100_ = autoExposure(drawLight(renderer_, camera_, settings_).total);
    }

    ErrorEstimate::Value wait(ErrorEstimate::Against against) {
        const ErrorEstimate estimate(renderer_, scene_, camera_, settings_, ev100_, against);
        while (!estimate.value().isDone) {
            std::this_thread::sleep_for(milliseconds(5));
        }
        return estimate.value();
    }
};

TEST_F(ErrorEstimateTest, IsThatOfTheWholePicture) {
    ReferenceSettings reference;
    reference.camera = camera_;
    reference.width = settings_.width;
    reference.height = settings_.height;
    reference.haze = settings_.haze;
    reference.ambientLux = settings_.ambientLux;
    const DrawnFrame drawn = drawForReference(renderer_, scene_, reference);
    reference.drawn = &drawn;
    const ReferencePicture right = drawReference(scene_, reference);
    const DrawnLight light = drawLight(renderer_, camera_, settings_);
    RgbPicture other = light.total;
    for (std::size_t i = 0; i < other.pixels.size(); ++i) {
        other.pixels[i] += glm::vec3(right.beams[i]) - light.beams.pixels[i];
    }
    const double whole =
        displayRmsePercent(displayPicture(light.total, ev100_), displayPicture(other, ev100_));

    const ErrorEstimate::Value value = wait(ErrorEstimate::Against::kShadowMaps);
    EXPECT_EQ(value.failure, "");
    EXPECT_GT(whole, 0.1);
    // Of a sample, or of all 5,184 pixels.
    EXPECT_NEAR(value.rmsePercent, whole, 4.0 * value.uncertainty + 1e-3);
}

TEST_F(ErrorEstimateTest, FallsWithMoreSheetsAndEndsWhenItGoes) {
    const double few = wait(ErrorEstimate::Against::kGeometry).rmsePercent;
    settings_.beams.planes = 64;
    EXPECT_LT(wait(ErrorEstimate::Against::kGeometry).rmsePercent, 0.5 * few);
    const auto start = std::chrono::steady_clock::now();
    settings_.width = 1920;
    settings_.height = 1080;
    {
        const ErrorEstimate estimate(renderer_, scene_, camera_, settings_, ev100_,
                                     ErrorEstimate::Against::kGeometry);
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

}  // namespace
}  // namespace ribalta::test
