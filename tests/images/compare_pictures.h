// How far two pictures are apart: two numbers, and a picture of the differences.
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"

namespace ribalta::test {

/// What is still the same picture.
struct Tolerance {
    double codeValues;   ///< how far a channel may be off, in 1/255, for a pixel to count as equal
    double pixelsShare;  ///< how many pixels may be further off, 0..1
};

struct Comparison {
    double shareOff = 0.0;  ///< 0..1: pixels with a channel further off than the tolerance
    double largest = 0.0;   ///< the largest difference of any channel, in 1/255
    /// R, G, B: the differences, eight times enlarged; pixels that count as equal are blue.
    std::vector<std::uint8_t> picture;
};

/// Compares R, G, B of two pictures of one size, values in 0..1. A value that is not a number is
/// off. CHECKs that the sizes agree.
Comparison comparePictures(const FloatImage& one, const FloatImage& other,
                           const Tolerance& tolerance);

}  // namespace ribalta::test
