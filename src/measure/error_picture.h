// ErrorPicture: where two pictures differ, to look at.
#pragma once

#include <cstdint>
#include <vector>

#include "measure/rgb_picture.h"

namespace ribalta {

/// sRGB-encoded 8-bit R, G, B, rows from the top: each pixel's largest channel difference of two
/// display pictures of one size, from black (none) by violet, red and yellow to white at
/// `fullPercent` of full scale and above.
std::vector<std::uint8_t> errorPicture(const RgbPicture& a, const RgbPicture& b,
                                       double fullPercent);

/// The colour of an error of 0..1 of the scale, sRGB-encoded 0..1. Its lightness rises evenly, so
/// that it reads without colour too.
glm::dvec3 errorColor(double error);

}  // namespace ribalta
