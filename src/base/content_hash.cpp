#include "base/content_hash.h"

#include <array>

namespace ribalta {

void ContentHash::add(std::span<const std::byte> bytes) {
    std::uint64_t state = state_;
    for (const std::byte value : bytes) {
        state = (state ^ std::to_integer<std::uint64_t>(value)) * 0x100000001b3;
    }
    state_ = state;
}

void ContentHash::add(std::string_view text) {
    addSize(text.size());
    add(std::as_bytes(std::span(text)));
}

void ContentHash::addSize(std::size_t size) {
    const std::array<std::size_t, 1> one = {size};
    add(std::as_bytes(std::span(one)));
}

std::string ContentHash::text() const {
    constexpr char kDigits[] = "0123456789abcdef";
    std::string text;
    for (int shift = 60; shift >= 0; shift -= 4) {
        text += kDigits[(state_ >> shift) & 15];
    }
    return text;
}

}  // namespace ribalta
