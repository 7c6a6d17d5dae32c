// Decoded images into textures.
#pragma once

#include <string>
#include <vector>

#include "gl/texture.h"
#include "image/image.h"

namespace ribalta {

/// A texture with mipmaps. `colors`: 8-bit values are sRGB-encoded; otherwise they are data. An
/// image larger than the driver's limit is halved until it fits, with a warning.
Texture2D uploadImage(const Image& image, bool colors);

/// Pictures of any shape, each stretched to a square layer of an array with mipmaps: as large as
/// the largest, at most kMaxLayerSide. Float if one of them is.
Texture2D uploadSquareLayers(const std::string& label, const std::vector<const Image*>& images);

inline constexpr int kMaxLayerSide = 2048;  ///< texels

}  // namespace ribalta
