// How large a picture says it is, from its first bytes, before any library is asked: a file of a
// few bytes may claim gigabytes. Decodes nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "image/image_format.h"

namespace ribalta {

struct ClaimedSize {
    std::int64_t width = 0;   ///< pixels; may be anything, zero and less among it
    std::int64_t height = 0;  ///< pixels
    int bytesPerPixel = 4;    ///< most that an Image needs once it is decoded
};

/// None where the header is not whole or is of an unusual form; then a decoder will find out. An
/// EXR's is the larger of what is stored and what is framed.
std::optional<ClaimedSize> claimedSize(std::span<const std::byte> encoded, ImageFormat format);

}  // namespace ribalta
