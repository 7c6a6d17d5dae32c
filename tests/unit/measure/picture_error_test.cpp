// The error measures against closed forms.
#include "measure/picture_error.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "make_picture.h"

namespace ribalta::test {
namespace {

TEST(LinearError, AConstantFactorIsTheRelativeError) {
    const auto ramp = [](int x, int y) { return glm::vec3(x + 1, y + 2, 3 * x + y) * 100.0F; };
    const RgbPicture b = makePicture(17, 9, ramp);
    const RgbPicture a =
        makePicture(17, 9, [&](int x, int y) { return 1.25F * glm::vec3(ramp(x, y)); });
    EXPECT_NEAR(linearError(a, b).relativeRmse, 0.25, 1e-9);
    // What is divided by is B: the other way round the factor is 1 / 1.25.
    EXPECT_NEAR(linearError(b, a).relativeRmse, 0.25 / 1.25, 1e-9);
}

TEST(LinearError, OnePixelOffInOneChannel) {
    const RgbPicture b = makeFlat(10, 10, glm::vec3(2.0F));
    RgbPicture a = b;
    a.pixels[37].y = 8.0F;
    const LinearError error = linearError(a, b);
    // sqrt(36 / 300) over 2.
    EXPECT_NEAR(error.relativeRmse, std::sqrt(36.0 / 300.0) / 2.0, 1e-12);
    EXPECT_EQ(error.largest.x, 7);
    EXPECT_EQ(error.largest.y, 3);
    EXPECT_EQ(error.largest.channel, 1);
    EXPECT_EQ(error.largest.a, 8.0);
    EXPECT_EQ(error.largest.b, 2.0);
    EXPECT_EQ(error.largest.size(), 6.0);
}

TEST(LinearError, BlackPictures) {
    const RgbPicture black = makeFlat(4, 4, glm::vec3(0.0F));
    EXPECT_EQ(linearError(black, black).relativeRmse, 0.0);
    EXPECT_EQ(linearError(makeFlat(4, 4, glm::vec3(1.0F)), black).relativeRmse,
              std::numeric_limits<double>::infinity());
    EXPECT_EQ(linearError(black, makeFlat(4, 4, glm::vec3(1.0F))).relativeRmse, 1.0);
}

TEST(DisplayError, AConstantOffset) {
    const RgbPicture b = makeFlat(8, 8, glm::vec3(100.0F / 255.0F));
    const RgbPicture a = makeFlat(8, 8, glm::vec3(110.0F / 255.0F));
    const DisplayError error = displayError(a, b);
    EXPECT_NEAR(error.rmsePercent, 1000.0 / 255.0, 1e-5);
    // 10 codes: 20 log10(255 / 10).
    EXPECT_NEAR(error.psnr, 28.130803608679106, 1e-9);
    EXPECT_NEAR(error.largest.size(), 10.0 / 255.0, 1e-7);
    EXPECT_NEAR(displayError(b, a).rmsePercent, error.rmsePercent, 1e-12);
    EXPECT_NEAR(displayError(b, a).flipMean, error.flipMean, 1e-12);
}

TEST(DisplayError, WhiteOnBlackIsFullScale) {
    const DisplayError error =
        displayError(makeFlat(5, 5, glm::vec3(1.0F)), makeFlat(5, 5, glm::vec3(0.0F)));
    EXPECT_EQ(error.rmsePercent, 100.0);
    EXPECT_EQ(error.psnr, 0.0);
    EXPECT_NEAR(error.flipMean, 0.96739, 1e-4);
}

TEST(DisplayError, EqualPicturesHaveInfinitePsnr) {
    const RgbPicture picture =
        makePicture(9, 6, [](int x, int y) { return glm::vec3(x, y, x + y) / 15.0F; });
    const DisplayError error = displayError(picture, picture);
    EXPECT_EQ(error.rmsePercent, 0.0);
    EXPECT_EQ(error.psnr, std::numeric_limits<double>::infinity());
    EXPECT_EQ(error.flipMean, 0.0);
    EXPECT_EQ(error.largest.size(), 0.0);
}

TEST(DisplayError, WhatEightBitsDoNotShowIsInTheRmseAlone) {
    const RgbPicture b = makeFlat(6, 6, glm::vec3(100.1F / 255.0F));
    const RgbPicture a = makeFlat(6, 6, glm::vec3(99.9F / 255.0F));
    const DisplayError error = displayError(a, b);
    EXPECT_NEAR(error.rmsePercent, 20.0 / 255.0, 1e-4);
    EXPECT_EQ(error.psnr, std::numeric_limits<double>::infinity());
}

TEST(DisplayError, OneByteOffInOneChannelOfOnePixel) {
    const RgbPicture b = makeFlat(10, 10, glm::vec3(0.0F));
    RgbPicture a = b;
    a.pixels[99].z = 1.0F / 255.0F;
    const DisplayError error = displayError(a, b);
    EXPECT_NEAR(error.psnr, 10.0 * std::log10(255.0 * 255.0 * 300.0), 1e-9);
    EXPECT_EQ(error.largest.x, 9);
    EXPECT_EQ(error.largest.y, 9);
    EXPECT_EQ(error.largest.channel, 2);
}

}  // namespace
}  // namespace ribalta::test
