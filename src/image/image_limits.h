// ImageLimits: the largest picture that is decoded, and what is said of a larger one.
#pragma once

#include <cstdint>
#include <string>

namespace ribalta {

/// Largest picture that is decoded; a larger one is refused before memory is taken.
struct ImageLimits {
    int maxSide = 32768;                               ///< pixels
    std::uint64_t maxPixels = std::uint64_t(1) << 28;  ///< width * height
};

/// One line on what is wrong with a size; empty where nothing is. Sides of any value.
inline std::string sizeFault(std::int64_t width, std::int64_t height, const ImageLimits& limits) {
    if (width <= 0 || height <= 0) {
        return "has no pixels";
    }
    if (width <= limits.maxSide && height <= limits.maxSide &&
        std::uint64_t(width) * std::uint64_t(height) <= limits.maxPixels) {
        return "";
    }
    return "has " + std::to_string(width) + " x " + std::to_string(height) +
           " pixels, over the limit of " + std::to_string(limits.maxSide) + " a side and " +
           std::to_string(limits.maxPixels) + " in all; scale it down";
}

}  // namespace ribalta
