#include <stdexcept>

#include <webp/decode.h>

#include "image/codec/decode.h"

namespace ribalta {

Image decodeWebp(std::span<const std::byte> encoded, const ImageLimits& limits) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(encoded.data());
    WebPBitstreamFeatures features;
    if (WebPGetFeatures(bytes, encoded.size(), &features) != VP8_STATUS_OK) {
        throw std::runtime_error("is a broken or truncated WebP picture; save it anew");
    }
    checkSize(features.width, features.height, limits);
    if (features.has_animation != 0) {
        throw std::runtime_error("is an animated WebP; expected a still picture");
    }
    Image image;
    image.width = features.width;
    image.height = features.height;
    image.pixels = RawBytes(std::size_t(image.width) * std::size_t(image.height) * 4);
    // Straight alpha; a missing one comes out opaque.
    if (WebPDecodeRGBAInto(bytes, encoded.size(),
                           reinterpret_cast<std::uint8_t*>(image.pixels.data()),
                           image.pixels.size(), image.width * 4) == nullptr) {
        throw std::runtime_error("is a broken or truncated WebP picture; save it anew");
    }
    return image;
}

}  // namespace ribalta
