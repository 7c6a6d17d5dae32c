// ImageCodec: the door between the program and its image module, a library opened at run time.
// The module alone knows OpenImageIO and libwebp; no type of theirs passes this door.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "image/image.h"
#include "image/image_format.h"
#include "image/read_image.h"

namespace ribalta {

/// Every function may be called from any thread, throws nothing, and answers with what went wrong
/// in one line, or an empty string. A result is only meaningful without an error.
struct ImageCodec {
    std::string (*decode)(std::span<const std::byte> encoded, ImageFormat format,
                          const ImageLimits& limits, Image& result);
    std::string (*decodeFloat)(std::span<const std::byte> encoded, ImageFormat format,
                               const ImageLimits& limits, FloatImage& result);
    std::string (*encodeExr)(const FloatImage& image, std::vector<unsigned char>& result);
};

/// The module, opened on the first call: looked for beside the executable, then in the installed
/// library folder. Throws Error(kJobFailed) where it cannot be opened.
const ImageCodec& imageCodec();

/// The one symbol the module exports; it returns a `const ImageCodec*`.
inline constexpr const char* kImageCodecSymbol = "ribaltaImageCodec";

}  // namespace ribalta
