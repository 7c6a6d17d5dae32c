// RgbPicture: three channels of a picture that is measured. No file formats, no layers.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "base/error.h"
#include "image/image.h"

namespace ribalta {

/// Linear luminance in cd/m2 or sRGB-encoded display values in 0..1; whoever takes one says which.
struct RgbPicture {
    int width = 0;
    int height = 0;
    std::vector<glm::vec3> pixels;  ///< rows from the top

    const glm::vec3& at(int x, int y) const {
        return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    }
};

/// R, G, B of `layer` ("beams": beams.R, beams.G, beams.B; empty: R, G, B, or a grey picture's Y
/// spread). Throws Error(kBadInput) at `place` that names the layers there are.
RgbPicture pickLayer(const FloatImage& image, const std::string& layer, const Place& place);

/// Throws Error(kBadInput) at `place` that counts the pixels that hold a NaN or an infinity and
/// says where the first one stands; nothing where there is none.
void refuseNonFinite(const RgbPicture& picture, const Place& place);

/// Throws Error(kBadInput) at `place` where the two are not of one size.
void refuseOtherSize(const RgbPicture& picture, const RgbPicture& expected, const Place& place);

}  // namespace ribalta
