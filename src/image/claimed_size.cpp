#include "image/claimed_size.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <string_view>

#include "base/bytes.h"

namespace ribalta {
namespace {

using Bytes = std::span<const std::byte>;

// Signature, then the chunk IHDR (PNG specification, section 11.2.2).
std::optional<ClaimedSize> ofPng(Bytes file) {
    if (file.size() < 24 || textOf(file.subspan(12, 4)) != "IHDR") {
        return std::nullopt;
    }
    return ClaimedSize{bigEndian(file, 16, 4), bigEndian(file, 20, 4)};
}

// The largest of all frame headers (ITU-T T.81, B.2.2): a decoder may take any for the picture's.
std::optional<ClaimedSize> ofJpeg(Bytes file) {
    std::optional<ClaimedSize> size;
    for (std::size_t at = 2; at + 9 <= file.size();) {
        if (file[at] != std::byte(0xFF)) {
            break;
        }
        const auto marker = std::to_integer<unsigned>(file[at + 1]);
        if (marker == 0xFF) {
            ++at;
            continue;
        }
        if (marker == 0xDA) {
            break;
        }
        const bool isFrame =
            marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
        if (isFrame) {
            const std::int64_t width = bigEndian(file, at + 7, 2);
            const std::int64_t height = bigEndian(file, at + 5, 2);
            if (!size || width * height > size->width * size->height) {
                size = ClaimedSize{width, height};
            }
        }
        at += 2 + bigEndian(file, at + 2, 2);
    }
    return size;
}

// The first directory's tags 256 and 257 (TIFF 6.0, section 2).
std::optional<ClaimedSize> ofTiff(Bytes file) {
    if (file.size() < 8) {
        return std::nullopt;
    }
    const bool isBigEndian = file[0] == std::byte('M');
    const auto number = isBigEndian ? bigEndian : littleEndian;
    const std::size_t directory = number(file, 4, 4);
    if (directory > file.size() - 2) {
        return std::nullopt;
    }
    ClaimedSize size{0, 0, 16};
    const std::size_t count = number(file, directory, 2);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t entry = directory + 2 + 12 * i;
        if (entry + 12 > file.size()) {
            return std::nullopt;
        }
        const std::uint32_t tag = number(file, entry, 2);
        const bool isShort = number(file, entry + 2, 2) == 3;
        const std::uint32_t value = number(file, entry + 8, isShort ? 2 : 4);
        if (tag == 256) {
            size.width = value;
        } else if (tag == 257) {
            size.height = value;
        }
    }
    return size;
}

// Name, type, size and value of each attribute, up to an empty name (OpenEXR file layout). Of
// several parts the first one's, which is the one that is read.
std::optional<ClaimedSize> ofOpenExr(Bytes file) {
    const std::string_view text = textOf(file);
    ClaimedSize size{0, 0, 16};
    for (std::size_t at = 8; at < text.size() && text[at] != '\0';) {
        const std::size_t nameEnd = text.find('\0', at);
        const std::size_t typeEnd =
            nameEnd == std::string_view::npos ? nameEnd : text.find('\0', nameEnd + 1);
        if (typeEnd == std::string_view::npos || typeEnd + 5 > text.size()) {
            return std::nullopt;
        }
        const std::string_view name = text.substr(at, nameEnd - at);
        const std::size_t length = littleEndian(file, typeEnd + 1, 4);
        const std::size_t value = typeEnd + 5;
        if (length > text.size() - value) {
            return std::nullopt;
        }
        if ((name == "dataWindow" || name == "displayWindow") && length == 16) {
            std::int32_t box[4];
            std::memcpy(box, &file[value], sizeof box);
            size.width = std::max(size.width, std::int64_t(box[2]) - box[0] + 1);
            size.height = std::max(size.height, std::int64_t(box[3]) - box[1] + 1);
        }
        at = value + length;
    }
    return size.width > 0 || size.height > 0 ? std::optional(size) : std::nullopt;
}

// The line behind the first empty one, such as "-Y 480 +X 640".
std::optional<ClaimedSize> ofHdr(Bytes file) {
    const std::string_view text = textOf(file);
    const std::size_t blank = text.find("\n\n");
    if (blank == std::string_view::npos) {
        return std::nullopt;
    }
    std::string_view line = text.substr(blank + 2, 100);
    line = line.substr(0, line.find('\n'));
    std::int64_t sides[2] = {0, 0};
    for (std::int64_t& side : sides) {
        const std::size_t digits = line.find_first_of("0123456789");
        if (digits == std::string_view::npos) {
            return std::nullopt;
        }
        const char* const end = line.data() + line.size();
        const auto [stop, error] = std::from_chars(line.data() + digits, end, side);
        if (error != std::errc()) {
            return std::nullopt;
        }
        line.remove_prefix(std::size_t(stop - line.data()));
    }
    return ClaimedSize{sides[1], sides[0], 16};
}

// The largest of the canvas and of both kinds of bitstream (RFC 9649, section 2).
std::optional<ClaimedSize> ofWebp(Bytes file) {
    if (file.size() < 30) {
        return std::nullopt;
    }
    const std::string_view kind = textOf(file.subspan(12, 4));
    if (kind == "VP8X") {
        return ClaimedSize{1 + littleEndian(file, 24, 3), 1 + littleEndian(file, 27, 3)};
    }
    if (kind == "VP8L") {
        const std::uint32_t bits = littleEndian(file, 21, 4);
        return ClaimedSize{1 + (bits & 0x3FFFU), 1 + ((bits >> 14U) & 0x3FFFU)};
    }
    if (kind == "VP8 ") {
        return ClaimedSize{littleEndian(file, 26, 2) & 0x3FFFU,
                           littleEndian(file, 28, 2) & 0x3FFFU};
    }
    return std::nullopt;
}

}  // namespace

std::optional<ClaimedSize> claimedSize(std::span<const std::byte> encoded, ImageFormat format) {
    switch (format) {
        case ImageFormat::kPng:
            return ofPng(encoded);
        case ImageFormat::kJpeg:
            return ofJpeg(encoded);
        case ImageFormat::kWebp:
            return ofWebp(encoded);
        case ImageFormat::kTiff:
            return ofTiff(encoded);
        case ImageFormat::kOpenExr:
            return ofOpenExr(encoded);
        case ImageFormat::kHdr:
            return ofHdr(encoded);
        case ImageFormat::kUnknown:
            break;
    }
    return std::nullopt;
}

}  // namespace ribalta
