// JPEGs through libjpeg-turbo, without OpenImageIO's libraries, which take a fifth of a second to
// open.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "image/image.h"
#include "image/image_limits.h"

namespace ribalta {

/// A JPEG in grey or colours, baseline or progressive; its metadata is ignored. None where it is in
/// printers' colours (CMYK), over the limits, broken or of another kind: the image module decodes
/// it then, or says what is wrong. Throws std::bad_alloc.
std::optional<Image> decodePlainJpeg(std::span<const std::byte> encoded, const ImageLimits& limits);

}  // namespace ribalta
