#include "gltf/find_named.h"

#include <algorithm>
#include <charconv>
#include <optional>

namespace ribalta::gltf {
namespace {

std::optional<std::size_t> numberIn(const std::string& text) {
    std::size_t number = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    return error == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

}  // namespace

std::size_t findNamed(const std::vector<std::string>& names, const std::string& nameOrIndex,
                      const char* thing, const char* none, const Place& file) {
    const auto named = std::find(names.begin(), names.end(), nameOrIndex);
    if (named != names.end()) {
        return std::size_t(named - names.begin());
    }
    const std::optional<std::size_t> number = numberIn(nameOrIndex);
    if (number && *number < names.size()) {
        return *number;
    }
    constexpr std::size_t kListed = 20;
    std::string there;
    for (std::size_t i = 0; i < std::min(names.size(), kListed); ++i) {
        there += (i == 0 ? "" : ", ") + std::to_string(i) + " " + names[i];
    }
    if (names.size() > kListed) {
        there += " and " + std::to_string(names.size() - kListed) + " more";
    }
    throw Error(ErrorKind::kUsage, file,
                std::string("has no ") + thing + " '" + nameOrIndex + "'; " +
                    (there.empty() ? none : "there are: " + there));
}

}  // namespace ribalta::gltf
