#include "gltf/read_uri.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <optional>
#include <system_error>

#include "gltf/bad_input.h"

namespace ribalta::gltf {
namespace {

std::optional<unsigned> hexDigit(char c) {
    if (c >= '0' && c <= '9') {
        return unsigned(c - '0');
    }
    const char lower = char(c | 0x20);
    if (lower >= 'a' && lower <= 'f') {
        return unsigned(lower - 'a' + 10);
    }
    return std::nullopt;
}

std::optional<unsigned> base64Digit(char c) {
    if (c >= 'A' && c <= 'Z') {
        return unsigned(c - 'A');
    }
    if (c >= 'a' && c <= 'z') {
        return unsigned(c - 'a' + 26);
    }
    if (c >= '0' && c <= '9') {
        return unsigned(c - '0' + 52);
    }
    if (c == '+' || c == '-') {
        return 62U;
    }
    if (c == '/' || c == '_') {
        return 63U;
    }
    return std::nullopt;
}

std::vector<std::byte> decodeBase64(std::string_view text, const Place& place) {
    while (text.ends_with('=')) {
        text.remove_suffix(1);
    }
    std::vector<std::byte> bytes;
    bytes.reserve(text.size() / 4 * 3 + 3);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const auto digit = base64Digit(c);
        if (!digit) {
            badInput(place, "holds a character that is not base64; export the file again");
        }
        bits = (bits << 6U) | *digit;
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes.push_back(std::byte((bits >> unsigned(count)) & 0xFFU));
        }
    }
    return bytes;
}

std::string shortened(std::string_view uri) {
    std::string text(uri.substr(0, 80));
    text.append(uri.size() > 80 ? "...\"" : "\"");
    return text.insert(0, 1, '"');
}

bool equalsIgnoringCase(std::string_view text, std::string_view lower) {
    return text.size() == lower.size() &&
           std::equal(text.begin(), text.end(), lower.begin(), [](char a, char b) {
               return std::tolower(static_cast<unsigned char>(a)) == b;
           });
}

// RFC 3986: a letter, then letters, digits, + - . up to a colon.
std::string_view schemeOf(std::string_view uri) {
    const std::size_t colon = uri.find(':');
    if (colon == std::string_view::npos || colon == 0 ||
        std::isalpha(static_cast<unsigned char>(uri[0])) == 0) {
        return {};
    }
    const std::string_view scheme = uri.substr(0, colon);
    const bool valid = std::all_of(scheme.begin(), scheme.end(), [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+' || c == '-' || c == '.';
    });
    return valid ? scheme : std::string_view();
}

}  // namespace

std::string percentDecode(std::string_view text) {
    std::string decoded;
    decoded.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '%' && i + 2 < text.size()) {
            const auto high = hexDigit(text[i + 1]);
            const auto low = hexDigit(text[i + 2]);
            if (high && low) {
                decoded += char(*high * 16 + *low);
                i += 2;
                continue;
            }
        }
        decoded += text[i];
    }
    return decoded;
}

bool isDataUri(std::string_view uri) {
    return equalsIgnoringCase(uri.substr(0, 5), "data:");
}

std::vector<std::byte> decodeDataUri(std::string_view uri, const Place& place) {
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos) {
        badInput(place, "is a data URI without a comma; expected data:[type][;base64],content");
    }
    const std::string_view header = uri.substr(5, comma - 5);
    const std::string_view content = uri.substr(comma + 1);
    const std::size_t semicolon = header.rfind(';');
    if (semicolon != std::string_view::npos &&
        equalsIgnoringCase(header.substr(semicolon + 1), "base64")) {
        return content.find('%') == std::string_view::npos
                   ? decodeBase64(content, place)
                   : decodeBase64(percentDecode(content), place);
    }
    const std::string decoded = percentDecode(content);
    const auto* bytes = reinterpret_cast<const std::byte*>(decoded.data());
    return {bytes, bytes + decoded.size()};
}

std::filesystem::path resolveUri(std::string_view uri, const std::filesystem::path& folder,
                                 const Place& place, bool allowOutside) {
    const std::string_view scheme = schemeOf(uri);
    if (!scheme.empty()) {
        badInput(place, "is " + shortened(uri) + ": \"" + std::string(scheme) +
                            ":\" is not read; put the file beside the scene and name it by a "
                            "relative path");
    }
    return resolvePath(percentDecode(uri), folder, place, allowOutside);
}

std::filesystem::path resolvePath(const std::string& path, const std::filesystem::path& folder,
                                  const Place& place, bool allowOutside) {
    const std::string cure =
        "; put the file beside the scene or below and name it by a relative path, or allow what "
        "lies outside (--allow-outside)";
    if (path.empty() || path.find('\0') != std::string::npos) {
        badInput(place, "is " + shortened(path) + ", which names no file" + cure);
    }
    const std::filesystem::path base = folder.empty() ? std::filesystem::path(".") : folder;
    const std::filesystem::path relative(path);
    if (allowOutside) {
        return base / relative;
    }
    if (relative.is_absolute() || path[0] == '\\' || !schemeOf(path).empty()) {
        badInput(place, "is " + shortened(path) + ", not a relative path" + cure);
    }
    std::error_code failed;
    const auto root = std::filesystem::weakly_canonical(base, failed);
    const auto target = failed ? std::filesystem::path()
                               : std::filesystem::weakly_canonical(base / relative, failed);
    if (failed) {
        badInput(place, "is " + shortened(path) +
                            ", which cannot be looked up: " + failed.message() + cure);
    }
    const auto [rootEnd, rest] =
        std::mismatch(root.begin(), root.end(), target.begin(), target.end());
    if (rootEnd != root.end()) {
        badInput(place, "is " + shortened(path) + ", which leaves the scene's folder" + cure);
    }
    return base / relative;
}

}  // namespace ribalta::gltf
