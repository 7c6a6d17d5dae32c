#include "image/essential_chunks.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "base/bytes.h"

namespace ribalta {
namespace {

using Bytes = std::span<const std::byte>;

// PNG's CRC (PNG specification, annex D), four bits at a step.
std::uint32_t crc32(Bytes bytes) {
    static constexpr std::array<std::uint32_t, 16> kTable = [] {
        std::array<std::uint32_t, 16> table{};
        for (std::uint32_t n = 0; n < 16; ++n) {
            std::uint32_t c = n;
            for (int bit = 0; bit < 4; ++bit) {
                c = (c & 1) != 0 ? 0xEDB88320U ^ (c >> 1) : c >> 1;
            }
            table[n] = c;
        }
        return table;
    }();
    std::uint32_t crc = 0xFFFFFFFFU;
    for (const std::byte byte : bytes) {
        crc ^= std::to_integer<std::uint32_t>(byte);
        crc = kTable[crc & 15] ^ (crc >> 4);
        crc = kTable[crc & 15] ^ (crc >> 4);
    }
    return ~crc;
}

void append(std::vector<std::byte>& to, Bytes bytes) {
    to.insert(to.end(), bytes.begin(), bytes.end());
}

EssentialChunks essentialPng(Bytes file) {
    constexpr std::size_t kSignature = 8;
    constexpr std::size_t kAroundData = 12;  // length, type, CRC
    EssentialChunks result;
    result.encoded.assign(file.begin(), file.begin() + kSignature);
    for (std::size_t at = kSignature; at + kAroundData <= file.size();) {
        const std::size_t length = bigEndian(file, at, 4);
        if (length > file.size() - at - kAroundData) {
            break;
        }
        const std::string_view type(reinterpret_cast<const char*>(&file[at + 4]), 4);
        const bool essential =
            type == "IHDR" || type == "PLTE" || type == "tRNS" || type == "IDAT" || type == "IEND";
        if (essential) {
            if (crc32(file.subspan(at + 4, length + 4)) != bigEndian(file, at + 8 + length, 4)) {
                result.wrong = "is a damaged PNG picture (wrong checksum in its " +
                               std::string(type) + " chunk); save it anew";
                return result;
            }
            append(result.encoded, file.subspan(at, length + kAroundData));
        }
        if (type == "IEND") {
            return result;
        }
        at += length + kAroundData;
    }
    result.wrong = "is a truncated PNG picture (" + std::to_string(file.size()) +
                   " bytes, and its end is missing); save it anew";
    return result;
}

// A marker's code stands behind an 0xFF; inside compressed data no 0xFF is followed by one.
std::size_t lastMarker(Bytes file, unsigned code) {
    for (std::size_t at = file.size(); at-- > 1;) {
        if (file[at] == std::byte(code) && file[at - 1] == std::byte(0xFF)) {
            return at;
        }
    }
    return 0;
}

EssentialChunks essentialJpeg(Bytes file) {
    constexpr unsigned kStartOfScan = 0xDA;
    constexpr unsigned kEndOfImage = 0xD9;
    constexpr unsigned kFirstApplication = 0xE0;  // JFIF
    constexpr unsigned kLastApplication = 0xEF;
    constexpr unsigned kAdobe = 0xEE;  // says how the colours are coded
    constexpr unsigned kComment = 0xFE;
    EssentialChunks result;
    const auto broken = [&] {
        result.wrong = "is a broken or truncated JPEG picture (" + std::to_string(file.size()) +
                       " bytes, and its end is missing); save it anew";
        return result;
    };
    const std::size_t scan = lastMarker(file, kStartOfScan);
    if (scan == 0 || lastMarker(file, kEndOfImage) < scan) {
        return broken();
    }
    result.encoded.assign(file.begin(), file.begin() + 2);
    for (std::size_t at = 2; at + 4 <= file.size();) {
        const auto marker = std::to_integer<unsigned>(file[at + 1]);
        if (file[at] != std::byte(0xFF)) {
            return broken();
        }
        if (marker == 0xFF) {  // padding
            ++at;
            continue;
        }
        if (marker == kStartOfScan) {
            append(result.encoded, file.subspan(at));
            return result;
        }
        const std::size_t length = 2 + bigEndian(file, at + 2, 2);
        if (length < 4 || length > file.size() - at) {
            return broken();
        }
        const bool metadata =
            marker == kComment ||
            (marker > kFirstApplication && marker <= kLastApplication && marker != kAdobe);
        if (!metadata) {
            append(result.encoded, file.subspan(at, length));
        }
        at += length;
    }
    return broken();
}

}  // namespace

EssentialChunks essentialChunks(std::span<const std::byte> encoded, ImageFormat format) {
    if (format == ImageFormat::kPng) {
        return essentialPng(encoded);
    }
    if (format == ImageFormat::kJpeg) {
        return essentialJpeg(encoded);
    }
    return {};
}

}  // namespace ribalta
