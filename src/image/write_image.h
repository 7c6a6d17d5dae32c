// Pictures to files: PNGs through libpng, EXRs through OpenImageIO, which is loaded on first use.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "image/image.h"

namespace ribalta {

/// Writes sRGB-encoded 8-bit R, G, B, rows from the top, as PNG. Appears whole or not at all.
/// Throws Error(kJobFailed).
void writePng(const std::filesystem::path& path, int width, int height,
              std::span<const std::uint8_t> rgb);

/// Writes all channels as 32-bit float EXR (ZIP). Appears whole or not at all.
/// Throws Error(kJobFailed).
void writeExr(const std::filesystem::path& path, const FloatImage& image);

}  // namespace ribalta
