// Pictures from files and from memory: PNGs and JPEGs directly, others through OpenImageIO, which
// is loaded on first use.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "base/error.h"
#include "image/image.h"
#include "image/image_limits.h"

namespace ribalta {

/// Decodes a whole encoded picture (PNG, JPEG, WebP, EXR, HDR, ...; by its content, not its name).
/// Throws Error(kBadInput) at `place` where it is broken, over the limits or of no known format.
/// Safe to call from several threads at once, and on bytes that another program writes to, of which
/// then comes any picture or an error.
Image decodeImage(std::span<const std::byte> encoded, const Place& place,
                  const ImageLimits& limits = {});

/// Reads a picture with all its channels as floats: EXR as stored, others scaled to 0..1.
/// Throws Error(kBadInput).
FloatImage readFloatImage(const std::filesystem::path& path);

}  // namespace ribalta
