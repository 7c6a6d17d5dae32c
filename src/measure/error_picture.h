// ErrorPicture: where two pictures differ, to look at, and pictures made small for a page.
#pragma once

#include <cstdint>
#include <vector>

#include "measure/rgb_picture.h"

namespace ribalta {

/// sRGB-encoded 8 bits, rows from the top: R, G, B, R, ...
struct BytePicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
};

/// Each pixel's largest channel difference of two display pictures of one size, from black (none)
/// by violet, red and yellow to white at `fullPercent` of full scale and above. Made at most
/// `maxWidth` pixels wide: of the pixels that fall together the largest error is shown.
BytePicture errorPicture(const RgbPicture& a, const RgbPicture& b, double fullPercent,
                         int maxWidth);

/// A display picture in 8 bits, at most `maxWidth` pixels wide: the mean of the pixels that fall
/// together.
BytePicture smallPicture(const RgbPicture& display, int maxWidth);

/// The colour of an error of 0..1 of the scale, sRGB-encoded 0..1. Its lightness rises evenly, so
/// that it reads without colour too.
glm::dvec3 errorColor(double error);

}  // namespace ribalta
