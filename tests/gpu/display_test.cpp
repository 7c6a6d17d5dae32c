// The picture for a screen: which way up it is, exposure, the exposure that is found, dither.
#include <algorithm>
#include <cmath>

#include "gpu_test.h"
#include "measure/display_picture.h"
#include "optics/shader_lib.h"
#include "support/stage.h"

namespace ribalta::test {
namespace {

constexpr int kSide = 64;

class Display : public GpuTest {
  protected:
    Display() { settings_.display = true; }

    /// Fills the whole view with one luminance in cd/m2.
    void fill(const glm::vec3& luminance) {
        scene_ = {};
        Material glowing = makeMaterial(glm::vec3(0.0F));
        glowing.emission = luminance;
        addShape(scene_, makeQuad({0, 0, 0}, {9, 0, 0}, {0, 9, 0}), glowing);
    }
    void draw() {
        Renderer renderer(scene_);
        renderer.draw(camera_, settings_);
        pixels_ = readDisplay(renderer.targets());
        ev100_ = renderer.ev100();
        linear_ = readBack(renderer).image;
    }
    int at(int x, int y, int channel) const {
        return pixels_.at((std::size_t(y) * std::size_t(settings_.width) + std::size_t(x)) * 3 +
                          std::size_t(channel));
    }
    /// Mean code value of a channel.
    double mean(int channel = 0) const {
        double sum = 0.0;
        for (auto i = std::size_t(channel); i < pixels_.size(); i += 3) {
            sum += pixels_[i];
        }
        return sum * 3.0 / double(pixels_.size());
    }

    Scene scene_;
    Camera camera_ = makeCamera({0, 0, 5}, {0, 0, 0});
    FrameSettings settings_ = measuringSettings(kSide, kSide);
    std::vector<std::uint8_t> pixels_;
    std::optional<double> ev100_;
    FloatImage linear_;
};

TEST_F(Display, RowsRunFromTheTopAndColumnsFromTheLeft) {
    Material glowing = makeMaterial(glm::vec3(0.0F));
    glowing.emission = {100.0F, 100.0F, 100.0F};
    addShape(scene_, makeQuad({-1, 1, 0}, {0.4F, 0, 0}, {0, 0.4F, 0}), glowing);
    settings_.ev100 = 5.0;
    draw();
    ASSERT_EQ(pixels_.size(), std::size_t(kSide * kSide * 3));
    int brightest[2][2] = {};
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            int& most = brightest[2 * y / kSide][2 * x / kSide];
            most = std::max(most, at(x, y, 0));
        }
    }
    EXPECT_GT(brightest[0][0], 200);
    EXPECT_LE(std::max({brightest[0][1], brightest[1][0], brightest[1][1]}), 1);
}

TEST_F(Display, AStopHalvesTheLight) {
    // 0.6 of white at EV100 = 8, in the straight part of the tone curve.
    fill(glm::vec3(float(0.6 * 1.2 * 256.0)));
    double linear[3] = {};
    for (int stop = 0; stop < 3; ++stop) {
        settings_.ev100 = 8.0 + stop;
        draw();
        EXPECT_EQ(ev100_, settings_.ev100);
        linear[stop] = shader::srgbDecodeChannel(mean() / 255.0);
    }
    EXPECT_NEAR(linear[0], 0.6, 0.003);
    EXPECT_NEAR(linear[1], 0.3, 0.003);
    EXPECT_NEAR(linear[2], 0.15, 0.003);
}

TEST_F(Display, DitherKeepsTheMeanBetweenCodeValues) {
    settings_.ev100 = 0.0;
    for (const double codes : {10.25, 100.5, 180.75}) {
        const double linear = shader::srgbDecodeChannel(codes / 255.0);
        fill(glm::vec3(float(1.2 * linear)));
        draw();
        EXPECT_NEAR(mean(), codes, 0.05);
        const auto [low, high] = std::minmax_element(pixels_.begin(), pixels_.end());
        EXPECT_EQ(*low, std::floor(codes));
        EXPECT_EQ(*high, std::floor(codes) + 1);
    }
}

TEST_F(Display, ColoursKeepTheirOrder) {
    fill({120.0F, 60.0F, 15.0F});
    settings_.ev100 = 7.0;
    draw();
    for (int c = 0; c < 3; ++c) {
        const double exposed = (c == 0 ? 120.0 : c == 1 ? 60.0 : 15.0) / (1.2 * 128.0);
        EXPECT_NEAR(mean(c) / 255.0, shader::srgbEncodeChannel(exposed), 0.003) << c;
    }
}

/// A stage as a file brings it: a floor, a ball, a beam in haze.
void setStage(Scene& scene, double candela) {
    scene = {};
    addShape(scene, makeQuad({0, 0, 0}, {8, 0, 0}, {0, 0, -8}), makeMaterial(glm::vec3(0.5F)));
    addShape(scene, makeSphere({0, 1, 0}, 0.6F), makeMaterial({0.7F, 0.3F, 0.2F}));
    scene.spotLights = {makeSpot({1, 6, 1}, {0, 0, 0}, 0.35, candela)};
}

TEST_F(Display, TheExposureFoundShowsBrightAndDimStagesAlike) {
    camera_ = makeCamera({0, 2, 8}, {0, 1.5, 0});
    settings_.haze.scatteringPerMetre = 0.03;
    settings_.beams.method =
        BeamMethod::kClipped;  // which cells adaptive samples is no matter here
    double found[2] = {};
    for (const int i : {0, 1}) {
        setStage(scene_, i == 0 ? 5e5 : 5.0);
        draw();
        int burnt = 0;
        int visible = 0;
        for (int p = 0; p < kSide * kSide; ++p) {
            const int most = std::max({at(p % kSide, p / kSide, 0), at(p % kSide, p / kSide, 1),
                                       at(p % kSide, p / kSide, 2)});
            burnt += most >= 254 ? 1 : 0;
            visible += most >= 60 ? 1 : 0;
        }
        EXPECT_LT(burnt, kSide * kSide / 20) << "candela " << (i == 0 ? 5e5 : 5.0);
        EXPECT_GT(visible, kSide * kSide / 20) << "candela " << (i == 0 ? 5e5 : 5.0);
        ASSERT_TRUE(ev100_.has_value());
        found[i] = *ev100_;
        // The CPU counts the same pixels; a few may fall into the next bin.
        EXPECT_NEAR(autoExposure(pickLayer(linear_, "", {})), found[i], 0.01);
    }
    // A hundred thousand times the light: log2 stops more, within an eighth of a stop's bin.
    EXPECT_NEAR(found[0] - found[1], std::log2(1e5), 0.2);
}

TEST_F(Display, ABlackPictureHasAnExposureAndStaysBlack) {
    draw();
    ASSERT_TRUE(ev100_.has_value());
    EXPECT_TRUE(std::isfinite(*ev100_));
    EXPECT_LE(*std::max_element(pixels_.begin(), pixels_.end()), 1);
}

TEST_F(Display, WithoutAScreenThereIsNoExposure) {
    settings_.display = false;
    Renderer renderer(scene_);
    renderer.draw(camera_, settings_);
    EXPECT_FALSE(renderer.ev100().has_value());
}

TEST_F(Display, TheDisplayLeavesTheLuminanceAlone) {
    fill({120.0F, 60.0F, 15.0F});
    settings_.ev100 = 2.0;
    draw();
    EXPECT_EQ(linear_.at(5, 5, 0), 120.0F);
    EXPECT_EQ(linear_.at(5, 5, 2), 15.0F);
}

}  // namespace
}  // namespace ribalta::test
