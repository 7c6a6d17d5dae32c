// Small pictures by formula.
#pragma once

#include "measure/rgb_picture.h"

namespace ribalta::test {

/// color(x, y) gives a glm::vec3 for every pixel, rows from the top.
template <typename Color>
RgbPicture makePicture(int width, int height, const Color& color) {
    RgbPicture picture{width, height, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            picture.pixels.emplace_back(color(x, y));
        }
    }
    return picture;
}

inline RgbPicture makeFlat(int width, int height, const glm::vec3& color) {
    return makePicture(width, height, [&](int, int) { return color; });
}

}  // namespace ribalta::test
