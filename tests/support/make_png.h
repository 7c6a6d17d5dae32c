// PNG files of any kind, right or wrong, written byte by byte (W3C PNG, second edition).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ribalta::test {

struct PngParts {
    std::uint32_t width = 1;
    std::uint32_t height = 1;
    int bitDepth = 8;
    int colorType = 6;  ///< 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA
    /// Rows as the file holds them, without filter bytes; all of one length.
    std::vector<std::string> rows{};
    /// The filter (0..4) of each row, from the first on; those after them have none.
    std::vector<int> filters{};
    std::string palette{};       ///< PLTE: R, G, B of every entry
    std::string transparency{};  ///< tRNS
    /// Chunks put in before the pixels as they are: type and content.
    std::vector<std::pair<std::string, std::string>> extra{};
};

std::vector<std::byte> makePng(const PngParts& parts);

}  // namespace ribalta::test
