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
    const std::vector<std::uint8_t> bytes = errorPicture(a, b, 10.0);
    ASSERT_EQ(bytes.size(), 9U);
    const glm::dvec3 half = errorColor(0.5);
    for (int c = 0; c < 3; ++c) {
        EXPECT_EQ(bytes[std::size_t(c)], 0);
        EXPECT_NEAR(bytes[std::size_t(3 + c)], 255.0 * half[c], 1.0);
        EXPECT_EQ(bytes[std::size_t(6 + c)], 255);
    }
}

}  // namespace
}  // namespace ribalta::test
