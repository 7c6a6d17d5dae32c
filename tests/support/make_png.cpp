#include "support/make_png.h"

#include <algorithm>
#include <cstdlib>
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

// What a filter takes from a byte: of its neighbours to the left, above, and above to the left.
int predicted(int filter, int left, int up, int upLeft) {
    const int gradient = left + up - upLeft;
    const int apart[] = {std::abs(gradient - left), std::abs(gradient - up),
                         std::abs(gradient - upLeft)};
    const int nearest = apart[0] <= apart[1] && apart[0] <= apart[2] ? left
                        : apart[1] <= apart[2]                       ? up
                                                                     : upLeft;
    const int by[] = {0, left, up, (left + up) / 2, nearest};
    return by[filter];
}

std::string filtered(const std::string& row, const std::string& above, std::size_t pixelBytes,
                     int filter) {
    std::string result(1, static_cast<char>(filter));
    const auto at = [](const std::string& bytes, std::size_t i, std::size_t back) {
        return i < back || i - back >= bytes.size()
                   ? 0
                   : int(static_cast<unsigned char>(bytes[i - back]));
    };
    for (std::size_t i = 0; i < row.size(); ++i) {
        result +=
            static_cast<char>(at(row, i, 0) - predicted(filter, at(row, i, pixelBytes),
                                                        at(above, i, 0), at(above, i, pixelBytes)));
    }
    return result;
}

std::size_t pixelBytesOf(const PngParts& parts) {
    const int channels = parts.colorType == 2   ? 3
                         : parts.colorType == 4 ? 2
                         : parts.colorType == 6 ? 4
                                                : 1;
    return std::max<std::size_t>(1, std::size_t(channels * parts.bitDepth) / 8);
}

}  // namespace

std::vector<std::byte> makePng(const PngParts& parts) {
    std::string header = bigEndian(parts.width) + bigEndian(parts.height);
    header += static_cast<char>(parts.bitDepth);
    header += static_cast<char>(parts.colorType);
    header += std::string(3, '\0');  // deflate, filters by row, not interlaced
    std::string pixels;
    std::string above;
    for (std::size_t y = 0; y < parts.rows.size(); ++y) {
        const int filter = y < parts.filters.size() ? parts.filters[y] : 0;
        pixels += filtered(parts.rows[y], above, pixelBytesOf(parts), filter);
        above = parts.rows[y];
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
