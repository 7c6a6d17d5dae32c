// Bytes as text.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace ribalta {

/// The same bytes, which must outlive the result; any encoding.
inline std::string_view textOf(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace ribalta
