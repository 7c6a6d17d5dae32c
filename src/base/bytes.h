// Bytes as text and as whole numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace ribalta {

/// The same bytes, which must outlive the result; any encoding.
inline std::string_view textOf(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The number of `size` <= 4 bytes from `offset`, most significant first. They must be there.
inline std::uint32_t bigEndian(std::span<const std::byte> bytes, std::size_t offset,
                               std::size_t size) {
    std::uint32_t value = 0;
    for (const std::byte byte : bytes.subspan(offset, size)) {
        value = value << 8U | std::to_integer<std::uint32_t>(byte);
    }
    return value;
}

/// The same, least significant first.
inline std::uint32_t littleEndian(std::span<const std::byte> bytes, std::size_t offset,
                                  std::size_t size) {
    std::uint32_t value = 0;
    for (std::size_t i = size; i-- > 0;) {
        value = value << 8U | std::to_integer<std::uint32_t>(bytes[offset + i]);
    }
    return value;
}

}  // namespace ribalta
