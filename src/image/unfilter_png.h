// PNG's row filters undone (W3C PNG, section 9.2): the part of a PNG's decoding that has no
// library.
#pragma once

#include <cstddef>

namespace ribalta {

/// So many bytes behind a row may be read, and are kept.
inline constexpr std::size_t kUnfilterOverread = 4;

/// Undoes one filter (0..4) in place. `above` is the row above, undone already, or zeros; both have
/// `bytes` bytes. `pixelBytes`: of a whole pixel, at least one. False for a filter that there is
/// not.
bool unfilterRow(int filter, std::size_t pixelBytes, const std::byte* above, std::byte* row,
                 std::size_t bytes);

}  // namespace ribalta
