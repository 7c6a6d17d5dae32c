// Tests of the metric itself.
#include "images/compare_pictures.h"

#include <limits>

#include <gtest/gtest.h>

namespace ribalta::test {
namespace {

FloatImage grey(int width, int height, float value) {
    return {
        width, height, {"R", "G", "B"}, std::vector<float>(std::size_t(width * height * 3), value)};
}

TEST(ComparePictures, EqualPicturesAreEqual) {
    const Comparison result = comparePictures(grey(5, 4, 0.5F), grey(5, 4, 0.5F), {0.0, 0.0});
    EXPECT_EQ(result.shareOff, 0.0);
    EXPECT_EQ(result.largest, 0.0);
    EXPECT_EQ(result.picture, std::vector<std::uint8_t>(5 * 4 * 3, 0));
}

TEST(ComparePictures, CountsPixelsAndNotChannels) {
    FloatImage other = grey(5, 4, 0.5F);
    other.values[3] += 10.0F / 255.0F;  // R of the second pixel
    other.values[4] -= 20.0F / 255.0F;  // and its G
    other.values[59] += 3.0F / 255.0F;  // B of the last one
    const Comparison result = comparePictures(grey(5, 4, 0.5F), other, {4.0, 0.0});
    EXPECT_NEAR(result.shareOff, 1.0 / 20.0, 1e-12);
    EXPECT_NEAR(result.largest, 20.0, 1e-4);
    EXPECT_EQ(result.picture[3], 159);  // 20 * 8, cut off to a whole number
    EXPECT_EQ(result.picture[57], 0);   // within the tolerance: blue alone
    EXPECT_GE(result.picture[59], 23);
    EXPECT_NEAR(comparePictures(grey(5, 4, 0.5F), other, {2.0, 0.0}).shareOff, 0.1, 1e-12);
}

TEST(ComparePictures, WorksBothWays) {
    const FloatImage dark = grey(2, 2, 0.0F);
    const FloatImage light = grey(2, 2, 1.0F);
    EXPECT_EQ(comparePictures(dark, light, {254.0, 0.0}).shareOff, 1.0);
    EXPECT_EQ(comparePictures(light, dark, {254.0, 0.0}).shareOff, 1.0);
}

TEST(ComparePictures, FindsChannelsByName) {
    FloatImage swapped = grey(1, 1, 0.0F);
    swapped.channels = {"B", "G", "R"};
    swapped.values = {0.1F, 0.2F, 0.3F};
    FloatImage plain = grey(1, 1, 0.0F);
    plain.values = {0.3F, 0.2F, 0.1F};
    EXPECT_EQ(comparePictures(swapped, plain, {0.0, 0.0}).largest, 0.0);
}

TEST(ComparePictures, WhatIsNoNumberIsOff) {
    FloatImage broken = grey(2, 1, 0.5F);
    broken.values[0] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(comparePictures(broken, broken, {255.0, 0.0}).shareOff, 0.5);
}

}  // namespace
}  // namespace ribalta::test
