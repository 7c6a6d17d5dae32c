// The difference picture: its scale and its colours.
#include "measure/error_picture.h"

#include <gtest/gtest.h>

#include "make_picture.h"
#include "optics/shader_lib.h"

namespace ribalta::test {
namespace {

double luminanceOf(const glm::dvec3& encoded) {
    return glm::dot(shader::srgbDecode(encoded), glm::dvec3(0.2126, 0.7152, 0.0722));
}

TEST(ErrorPicture, RunsFromBlackToWhiteAndNeverDarkens) {
    EXPECT_LT(glm::length(errorColor(0.0)), 1e-6);
    EXPECT_GT(glm::length(errorColor(1.0) - glm::dvec3(0.0)), 1.7);
    double last = -1.0;
    for (int i = 0; i <= 100; ++i) {
        const double now = luminanceOf(errorColor(i / 100.0));
        EXPECT_GT(now, last) << i;
        last = now;
    }
}

TEST(ErrorPicture, TakesTheLargestChannelAgainstTheScale) {
    const RgbPicture b = makeFlat(3, 1, glm::vec3(0.5F));
    RgbPicture a = b;
    a.pixels[1] = {0.5F, 0.45F, 0.51F};
    a.pixels[2] = {1.0F, 0.5F, 0.5F};
    const std::vector<std::uint8_t> bytes = errorPicture(a, b, 10.0, 3).rgb;
    ASSERT_EQ(bytes.size(), 9U);
    const glm::dvec3 half = errorColor(0.5);
    for (int c = 0; c < 3; ++c) {
        EXPECT_EQ(bytes[std::size_t(c)], 0);
        EXPECT_NEAR(bytes[std::size_t(3 + c)], 255.0 * half[c], 1.0);
        EXPECT_EQ(bytes[std::size_t(6 + c)], 255);
    }
}

TEST(ErrorPicture, KeepsAnErrorOfOnePixelWhenMadeSmall) {
    const RgbPicture b = makeFlat(7, 5, glm::vec3(0.0F));
    RgbPicture a = b;
    a.pixels[2 * 7 + 6].y = 1.0F;
    const BytePicture small = errorPicture(a, b, 100.0, 4);
    ASSERT_EQ(small.width, 4);
    ASSERT_EQ(small.height, 3);
    for (std::size_t i = 0; i < small.rgb.size(); ++i) {
        // Pixel (6, 2) lies in the square (3, 1).
        EXPECT_EQ(small.rgb[i], i / 3 == 1 * 4 + 3 ? 255 : 0) << i;
    }
}

TEST(SmallPicture, IsTheMean) {
    const RgbPicture picture =
        makePicture(4, 2, [](int x, int y) { return glm::vec3(float(x % 2), float(y), 1.0F); });
    const BytePicture small = smallPicture(picture, 2);
    ASSERT_EQ(small.width, 2);
    ASSERT_EQ(small.height, 1);
    EXPECT_EQ(small.rgb, (std::vector<std::uint8_t>{128, 128, 255, 128, 128, 255}));
    EXPECT_EQ(smallPicture(picture, 100).width, 4);
}

}  // namespace
}  // namespace ribalta::test
