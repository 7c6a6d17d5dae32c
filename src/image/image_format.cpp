#include "image/image_format.h"

#include <array>
#include <cstring>
#include <string_view>

namespace ribalta {
namespace {

using namespace std::string_view_literals;

bool holds(std::span<const std::byte> bytes, std::size_t offset, std::string_view what) {
    return bytes.size() >= offset + what.size() &&
           std::memcmp(bytes.data() + offset, what.data(), what.size()) == 0;
}

}  // namespace

ImageFormat imageFormat(std::span<const std::byte> encoded) {
    if (holds(encoded, 0, "\x89PNG\r\n\x1a\n"sv)) {
        return ImageFormat::kPng;
    }
    if (holds(encoded, 0, "\xff\xd8\xff"sv)) {
        return ImageFormat::kJpeg;
    }
    if (holds(encoded, 0, "RIFF"sv) && holds(encoded, 8, "WEBP"sv)) {
        return ImageFormat::kWebp;
    }
    if (holds(encoded, 0, "II*\0"sv) || holds(encoded, 0, "MM\0*"sv)) {
        return ImageFormat::kTiff;
    }
    if (holds(encoded, 0, "v/1\x01"sv)) {
        return ImageFormat::kOpenExr;
    }
    if (holds(encoded, 0, "#?RADIANCE"sv) || holds(encoded, 0, "#?RGBE"sv)) {
        return ImageFormat::kHdr;
    }
    return ImageFormat::kUnknown;
}

std::string describeUnknownImage(std::span<const std::byte> encoded) {
    struct Known {
        std::size_t offset;
        std::string_view magic;
        const char* name;
    };
    static constexpr std::array kKnown{
        Known{0, "\xabKTX 20"sv, "a KTX2 texture"},
        Known{0, "\xabKTX 11"sv, "a KTX texture"},
        Known{0, "DDS "sv, "a DDS texture"},
        Known{0, "GIF8"sv, "a GIF picture"},
        Known{0, "BM"sv, "a BMP picture"},
        Known{4, "ftypavif"sv, "an AVIF picture"},
        Known{4, "ftypheic"sv, "a HEIC picture"},
        Known{0, "8BPS"sv, "a Photoshop picture"},
        Known{0, "<"sv, "an SVG or a web page"},
        Known{0, "version https://git-lfs"sv, "a Git LFS pointer, not the file itself"},
    };
    if (encoded.empty()) {
        return "nothing (0 bytes)";
    }
    for (const Known& known : kKnown) {
        if (holds(encoded, known.offset, known.magic)) {
            return known.name;
        }
    }
    return "no known picture format";
}

}  // namespace ribalta
