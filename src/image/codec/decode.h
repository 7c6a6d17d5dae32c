// The module's decoders. They throw std::runtime_error with a line for the user; the door in
// image_module.cpp turns it into the ImageCodec's answer.
#pragma once

#include <cstddef>
#include <span>

#include "image/image_codec.h"

namespace ribalta {

/// Every format but WebP, through OpenImageIO.
Image decodeWithOiio(std::span<const std::byte> encoded, ImageFormat format,
                     const ImageLimits& limits);
FloatImage decodeFloatWithOiio(std::span<const std::byte> encoded, ImageFormat format,
                               const ImageLimits& limits);

/// WebP, through libwebp: OpenImageIO 2.4 premultiplies its colours in 8 bits whatever it is asked
/// for, which loses all colour under transparent texels.
Image decodeWebp(std::span<const std::byte> encoded, const ImageLimits& limits);

/// Throws where a picture of this size is over the limits.
void checkSize(std::int64_t width, std::int64_t height, const ImageLimits& limits);

}  // namespace ribalta
