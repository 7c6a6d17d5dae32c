// encodePng: 8-bit pictures to the bytes of a file, by libpng.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ribalta {

/// A PNG of 8 bits a channel, marked as sRGB. `rgb`: rows from the top, width * height * 3. What is
/// wrong in one line where it cannot be encoded, else empty.
std::string encodePng(int width, int height, std::span<const std::uint8_t> rgb,
                      std::vector<unsigned char>& result);

}  // namespace ribalta
