// What outputs are checked for beside their format: that none replaces what it is made from, and
// that light in them is finite.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "image/image.h"

namespace ribalta {

/// Throws Error(kUsage) where writing `output` would replace one of `inputs`, by whatever name.
void refuseReplacing(const std::filesystem::path& output,
                     const std::vector<std::filesystem::path>& inputs);

/// Warns of pixels with light that a float cannot hold. Depth may be infinite.
void warnOfNonFinite(const FloatImage& image, const std::filesystem::path& file);

}  // namespace ribalta
