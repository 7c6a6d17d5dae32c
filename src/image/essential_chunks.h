// A PNG or JPEG without what is not pixels. No pixel is decoded here.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "image/image_format.h"

namespace ribalta {

/// What remains of a file, or what is wrong with it.
struct EssentialChunks {
    std::vector<std::byte> encoded;  ///< empty where nothing had to go: use the file as it is
    std::string wrong;               ///< one line; empty where the file is whole
};

/// Drops text, colour profiles, thumbnails and camera data, which glTF (section 3.8.1) has ignored,
/// which libraries comment on stderr, and which may inflate without limit. Finds files that are cut
/// short or, in a PNG, damaged, where a JPEG library would quietly fill in grey. Other formats
/// pass.
EssentialChunks essentialChunks(std::span<const std::byte> encoded, ImageFormat format);

}  // namespace ribalta
