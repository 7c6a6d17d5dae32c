#include "support/make_png.h"

#include <algorithm>
#include <cstring>

namespace ribalta::test {
namespace {

std::string bigEndian(std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) {
        bytes += static_cast<char>(value >> shift & 0xFF);
    }
    return bytes;
}

std::uint32_t crc32(std::string_view bytes) {
    std::uint32_t crc = 0xFFFFFFFFU;
    for (const char byte : bytes) {
        crc ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc & 1) != 0 ? 0xEDB88320U ^ (crc >> 1) : crc >> 1;
        }
    }
    return ~crc;
}

std::string chunk(const std::string& type, const std::string& content) {
    return bigEndian(static_cast<std::uint32_t>(content.size())) + type + content +
           bigEndian(crc32(type + content));
}

// A zlib stream of uncompressed blocks (RFC 1950, RFC 1951 section 3.2.4).
std::string stored(const std::string& bytes) {
    constexpr std::size_t kBlock = 65535;
    std::string stream = "\x78\x01";
    for (std::size_t at = 0; at < bytes.size() || at == 0; at += kBlock) {
        const std::size_t size = std::min(kBlock, bytes.size() - at);
        stream += static_cast<char>(at + size == bytes.size() ? 1 : 0);
        for (const std::size_t field : {size, ~size}) {
            stream += static_cast<char>(field & 0xFF);
            stream += static_cast<char>(field >> 8 & 0xFF);
        }
        stream += bytes.substr(at, size);
    }
    std::uint32_t a = 1;
    std::uint32_t b = 0;
    for (const char byte : bytes) {
        a = (a + static_cast<unsigned char>(byte)) % 65521;
        b = (b + a) % 65521;
    }
    return stream + bigEndian(b << 16 | a);
}

}  // namespace

std::vector<std::byte> makePng(const PngParts& parts) {
    std::string header = bigEndian(parts.width) + bigEndian(parts.height);
    header += static_cast<char>(parts.bitDepth);
    header += static_cast<char>(parts.colorType);
    header += std::string(3, '\0');  // deflate, filters by row, not interlaced
    std::string pixels;
    for (const std::string& row : parts.rows) {
        pixels += '\0' + row;
    }
    std::string file = "\x89PNG\r\n\x1a\n" + chunk("IHDR", header);
    for (const auto& [type, content] : parts.extra) {
        file += chunk(type, content);
    }
    if (!parts.palette.empty()) {
        file += chunk("PLTE", parts.palette);
    }
    if (!parts.transparency.empty()) {
        file += chunk("tRNS", parts.transparency);
    }
    file += chunk("IDAT", stored(pixels)) + chunk("IEND", "");
    std::vector<std::byte> bytes(file.size());
    std::memcpy(bytes.data(), file.data(), file.size());
    return bytes;
}

}  // namespace ribalta::test
