#include "image/image.h"

#include <algorithm>

namespace ribalta {

int FloatImage::channel(const std::string& name) const {
    const auto found = std::find(channels.begin(), channels.end(), name);
    return found == channels.end() ? -1 : static_cast<int>(found - channels.begin());
}

Image makeStandInImage(const std::string& name) {
    constexpr int kSide = 64;
    constexpr int kSquare = 8;
    Image image;
    image.name = name;
    image.width = kSide;
    image.height = kSide;
    image.pixels = RawBytes(std::size_t(kSide) * kSide * 4);
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const bool magenta = ((x / kSquare) + (y / kSquare)) % 2 == 0;
            std::byte* pixel = &image.pixels[(std::size_t(y) * kSide + std::size_t(x)) * 4];
            pixel[0] = pixel[2] = std::byte(magenta ? 255 : 0);
            pixel[1] = std::byte(0);
            pixel[3] = std::byte(255);
        }
    }
    return image;
}

}  // namespace ribalta
