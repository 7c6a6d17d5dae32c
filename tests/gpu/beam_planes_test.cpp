// Beams, method `planes`: the thesis's own sheets come to the same integral as they grow in number.
#include <cmath>

#include "reference_beams.h"
#include "support/stage.h"

namespace ribalta::test {
namespace {

class BeamPlanes : public GpuTest {
  protected:
    BeamPlanes() {
        SpotLight lamp = makeSpot({0.0, 5.0, 0.0}, {0.3, 0.0, 0.2}, 0.3, 10000.0);
        lamp.innerConeAngle = 0.2;
        scene_.spotLights.push_back(lamp);
        addShape(scene_, makeQuad({0, 0, 0}, {8, 0, 0}, {0, 0, -8}), makeMaterial(glm::vec3(0.5F)));
        settings_.haze.scatteringPerMetre = 0.05;
        settings_.beams.method = BeamMethod::kPlanes;
    }

    Scene scene_;
    // Every ray through the beam ends on the floor or leaves the beam: planes end with the scene.
    Camera camera_ = makeCamera({2.0, 2.5, 7.0}, {0.0, 2.0, 0.0}, 0.7);
    FrameSettings settings_ = measuringSettings(32, 24);
};

TEST_F(BeamPlanes, ConvergeToTheIntegral) {
    const Picture exact = referenceBeams(scene_, camera_, settings_, floorEnd);
    double before = 1.0;
    for (const int planes : {64, 256, 1024, 4096}) {
        settings_.beams.planes = planes;
        const double error = relativeRmse(drawnBeams(scene_, camera_, settings_), exact);
        EXPECT_LT(error, before) << planes;
        before = error;
    }
    EXPECT_LT(before, 0.005);
}

TEST_F(BeamPlanes, AgreeWithClippedSheets) {
    settings_.beams.planes = 4096;
    const Picture planes = drawnBeams(scene_, camera_, settings_);
    settings_.beams.method = BeamMethod::kClipped;
    settings_.beams.planes = 64;
    EXPECT_LT(relativeRmse(planes, drawnBeams(scene_, camera_, settings_)), 0.005);
}

TEST_F(BeamPlanes, AStepIsAsLongAsTheRaysOwn) {
    // So wide a view that the corner's ray is 3.2 times as long as its depth.
    scene_.spotLights[0] = makeSpot({0.0, 9.0, -5.0}, {0.0, 0.0, -5.0}, 1.2, 10000.0);
    scene_.spotLights[0].beamShape = BeamShape::kPyramid;
    camera_ = makeCamera({0.0, 3.0, 0.0}, {0.0, 3.0, -1.0}, 2.3);
    settings_.width = 16;
    settings_.height = 12;
    settings_.beams.planes = 2000;
    Picture exact = referenceBeams(scene_, camera_, settings_, floorEnd);
    Picture drawn = drawnBeams(scene_, camera_, settings_);
    const PixelRay corner = pixelRay(camera_, 16, 12, 15, 11);
    EXPECT_GT(corner.metresPerDepth, 3.0);
    for (const glm::ivec2 pixel : {glm::ivec2(0, 11), glm::ivec2(15, 11), glm::ivec2(8, 10)}) {
        const double right = exact.at(pixel.x, pixel.y).x;
        ASSERT_GT(right, 0.0);
        EXPECT_NEAR(drawn.at(pixel.x, pixel.y).x, right, 0.02 * right)
            << pixel.x << ", " << pixel.y;
    }
}

TEST_F(BeamPlanes, CellsConvergeToEveryPixel) {
    settings_.beams.planes = 60;
    const Picture everyPixel = drawnBeams(scene_, camera_, settings_);
    double before = 10.0;
    for (const int cells : {4, 8, 16, 32, 64}) {
        settings_.beams.cellsAcross = cells;
        settings_.beams.cellsDown = cells;
        const double error = relativeRmse(drawnBeams(scene_, camera_, settings_), everyPixel);
        EXPECT_LT(error, before) << cells;
        before = error;
    }
    // Beside the lamp the inverse square bends even within the half pixel that a cell is by then.
    EXPECT_LT(before, 0.01);
}

TEST_F(BeamPlanes, GibbonsFactorScalesTheBeams) {
    settings_.beams.planes = 40;
    settings_.haze.phase.k = 0.04;
    const Picture once = drawnBeams(scene_, camera_, settings_);
    settings_.haze.phase.k = 20.0;
    const Picture bright = drawnBeams(scene_, camera_, settings_);
    double sum = 0.0;
    for (std::size_t i = 0; i < once.pixels.size(); ++i) {
        EXPECT_NEAR(bright.pixels[i].x, 500.0 * once.pixels[i].x, 1e-4 * bright.pixels[i].x);
        sum += once.pixels[i].x;
    }
    EXPECT_GT(sum, 0.0);
}

TEST_F(BeamPlanes, AGivenSpacingIsTheStep) {
    // The beam lies in the middle of the depth range: planes that stand ten times as close there
    // come to the same sum as ten times as many.
    camera_ = makeCamera({0.0, 2.5, 8.1}, {0.0, 2.4, 0.0}, 0.5);
    const Picture exact = referenceBeams(scene_, camera_, settings_, floorEnd);
    settings_.beams.planes = 1000;
    settings_.beams.spacingMetres = 0.004;
    EXPECT_LT(relativeRmse(drawnBeams(scene_, camera_, settings_), exact), 0.02);
    // So few that they end before the beam.
    settings_.beams.planes = 10;
    settings_.beams.spacingMetres = 0.001;
    double sum = 0.0;
    for (const glm::dvec3& pixel : drawnBeams(scene_, camera_, settings_).pixels) {
        sum += pixel.x;
    }
    double whole = 0.0;
    for (const glm::dvec3& pixel : exact.pixels) {
        whole += pixel.x;
    }
    EXPECT_LT(sum, 0.1 * whole);
}

}  // namespace
}  // namespace ribalta::test
