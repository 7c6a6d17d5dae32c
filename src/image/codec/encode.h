// The module's encoders: pictures to the bytes of a file, in memory, through OpenImageIO. They
// throw std::runtime_error with a line for the user.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "image/image.h"

namespace ribalta {

/// Before the names of FloatImage::facts as attributes of an EXR, apart from what other programs
/// and the format itself have there.
inline constexpr const char* kFactPrefix = "ribalta/";

/// 32-bit float, ZIP, the channels under their own names.
std::vector<unsigned char> encodeExr(const FloatImage& image);

}  // namespace ribalta
