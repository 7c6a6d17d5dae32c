// A number as options take it: the whole text, nothing before or after it.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace ribalta {

/// None where the text is no number, or is not finite.
template <typename Number>
std::optional<Number> parseNumber(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
        return std::nullopt;
    }
    if constexpr (std::is_floating_point_v<Number>) {
        if (!std::isfinite(value)) {
            return std::nullopt;
        }
    }
    return value;
}

/// "64M" and the like, at least 1: K, M, G are thousands, millions and billions.
inline std::optional<std::uint64_t> parseCount(std::string_view text) {
    std::uint64_t unit = 1;
    if (!text.empty()) {
        const std::size_t suffix = std::string_view("KMG").find(text.back());
        if (suffix != std::string_view::npos) {
            constexpr std::uint64_t kUnits[] = {1'000, 1'000'000, 1'000'000'000};
            unit = kUnits[suffix];
            text.remove_suffix(1);
        }
    }
    const std::optional<std::uint64_t> count = parseNumber<std::uint64_t>(text);
    if (!count || *count == 0 || *count > UINT64_MAX / unit) {
        return std::nullopt;
    }
    return *count * unit;
}

}  // namespace ribalta
