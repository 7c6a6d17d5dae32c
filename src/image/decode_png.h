// PNGs as artists' programs write them, decoded here and fast; OpenImageIO, whose libraries take
// a fifth of a second to open, is left the rest.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "image/image.h"
#include "image/image_limits.h"

namespace ribalta {

/// A PNG (W3C PNG, second edition) of any colour type and bit depth, with its transparency; text,
/// profiles and gamma are ignored. None where it is interlaced, over the limits or in any way
/// damaged or odd: the image module decodes it then, or says what is wrong. Throws std::bad_alloc.
std::optional<Image> decodePlainPng(std::span<const std::byte> encoded, const ImageLimits& limits);

}  // namespace ribalta
