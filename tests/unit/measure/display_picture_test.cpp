// Exposure and tone curve on the CPU. That the renderer finds the same exposure is tests/gpu's.
#include "measure/display_picture.h"

#include <cmath>

#include <gtest/gtest.h>

#include "make_picture.h"
#include "optics/shader_lib.h"

namespace ribalta::test {
namespace {

TEST(DisplayPicture, EncodesWhatIsExposed) {
    // Half of white at EV100 = 3: 1.2 * 8 cd/m2 are 1.
    const RgbPicture shown = displayPicture(makeFlat(2, 3, glm::vec3(4.8F, 0.0F, -1.0F)), 3.0);
    ASSERT_EQ(shown.pixels.size(), 6U);
    for (const glm::vec3& color : shown.pixels) {
        EXPECT_NEAR(color.x, 0.7353569831, 1e-6);  // IEC 61966-2-1 of 0.5
        EXPECT_EQ(color.y, 0.0F);
        EXPECT_EQ(color.z, 0.0F);
    }
}

TEST(DisplayPicture, NothingIsBrighterThanWhite) {
    const RgbPicture shown = displayPicture(makeFlat(1, 1, glm::vec3(1e30F, 5.0F, 0.0F)), 0.0);
    for (int c = 0; c < 3; ++c) {
        EXPECT_GE(shown.pixels[0][c], 0.0F);
        EXPECT_LE(shown.pixels[0][c], 1.0F);
    }
}

TEST(AutoExposure, ShowsAnEvenPictureAsMiddleGrey) {
    for (const float luminance : {0.01F, 1.0F, 3000.0F}) {
        const RgbPicture even = makeFlat(64, 64, glm::vec3(luminance));
        const double exposed = double(luminance) * shader::exposureFromEv100(autoExposure(even));
        // Within the eighth of a stop of a bin.
        EXPECT_NEAR(std::log2(exposed / 0.18), 0.0, 1.0 / 16.0 + 1e-9) << luminance;
    }
}

TEST(AutoExposure, TwiceTheLightIsAStopMore) {
    const auto stage = [](float light) {
        return makePicture(320, 180, [=](int x, int y) {
            return x > 100 ? glm::vec3(light * float(1 + x % 50) * float(1 + y)) : glm::vec3(0.0F);
        });
    };
    EXPECT_NEAR(autoExposure(stage(2.0F)) - autoExposure(stage(1.0F)), 1.0, 1e-9);
}

TEST(AutoExposure, BlackHasAFixedOne) {
    EXPECT_NEAR(autoExposure(makeFlat(8, 8, glm::vec3(0.0F))), -std::log2(1.2), 1e-12);
}

}  // namespace
}  // namespace ribalta::test
