#include "image/decode_png.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <new>
#include <string_view>
#include <utility>
#include <vector>

#include <libdeflate.h>

#include "base/bytes.h"
#include "image/unfilter_png.h"

namespace ribalta {
namespace {

using Bytes = std::span<const std::byte>;

constexpr std::size_t kSignature = 8;
constexpr std::size_t kAroundData = 12;  // length, type, CRC

enum ColorType : int { kGrey = 0, kRgb = 2, kPalette = 3, kGreyAlpha = 4, kRgba = 6 };

struct Header {
    int width = 0;
    int height = 0;
    int bitDepth = 0;
    int colorType = 0;
    int channels = 0;

    std::size_t bitsPerPixel() const { return std::size_t(bitDepth) * std::size_t(channels); }
    std::size_t rowBytes() const { return (std::size_t(width) * bitsPerPixel() + 7) / 8; }
};

/// The parts that pixels come from.
struct Parts {
    Header header;
    std::vector<Bytes> compressed;  ///< IDAT by IDAT
    Bytes palette;
    Bytes transparency;
};

int channelsOf(int colorType) {
    switch (colorType) {
        case kGrey:
        case kPalette:
            return 1;
        case kGreyAlpha:
            return 2;
        case kRgb:
            return 3;
        case kRgba:
            return 4;
        default:
            return 0;
    }
}

bool isDepthAllowed(const Header& header) {
    const int depth = header.bitDepth;
    const bool isSmall = depth == 1 || depth == 2 || depth == 4;
    return depth == 8 || (depth == 16 && header.colorType != kPalette) ||
           (isSmall && (header.colorType == kGrey || header.colorType == kPalette));
}

std::optional<Header> readHeader(Bytes content, const ImageLimits& limits) {
    if (content.size() != 13) {
        return std::nullopt;
    }
    const std::uint32_t width = bigEndian(content, 0, 4);
    const std::uint32_t height = bigEndian(content, 4, 4);
    Header header;
    header.bitDepth = std::to_integer<int>(content[8]);
    header.colorType = std::to_integer<int>(content[9]);
    header.channels = channelsOf(header.colorType);
    // Compression and filtering have one kind each; what is interlaced is rare.
    const bool isUsual = bigEndian(content, 10, 3) == 0;
    if (!sizeFault(width, height, limits).empty() || header.channels == 0 ||
        !isDepthAllowed(header) || !isUsual) {
        return std::nullopt;
    }
    header.width = int(width);
    header.height = int(height);
    return header;
}

// One chunk into the parts; false where it does not belong where it stands.
bool takeChunk(std::string_view type, Bytes content, bool isAfterOther, const ImageLimits& limits,
               Parts& parts) {
    const bool hasHeader = parts.header.width > 0;
    if (type == "IHDR") {
        const std::optional<Header> header = readHeader(content, limits);
        if (hasHeader || !header) {
            return false;
        }
        parts.header = *header;
    } else if (type == "PLTE") {
        if (!hasHeader || !parts.palette.empty() || !parts.compressed.empty() || content.empty() ||
            content.size() % 3 != 0 || content.size() > 768) {
            return false;
        }
        parts.palette = content;
    } else if (type == "tRNS") {
        if (!hasHeader || !parts.transparency.empty() || !parts.compressed.empty()) {
            return false;
        }
        parts.transparency = content;
    } else if (type == "IDAT") {
        if (!hasHeader || (isAfterOther && !parts.compressed.empty())) {
            return false;
        }
        parts.compressed.push_back(content);
    }
    return true;
}

// None where chunks are missing, damaged, in disorder, or say what they must not.
std::optional<Parts> readParts(Bytes file, const ImageLimits& limits) {
    Parts parts;
    std::string_view last;
    for (std::size_t at = kSignature; at + kAroundData <= file.size();) {
        const std::size_t length = bigEndian(file, at, 4);
        if (length > file.size() - at - kAroundData) {
            return std::nullopt;
        }
        const std::string_view type(reinterpret_cast<const char*>(&file[at + 4]), 4);
        const Bytes content = file.subspan(at + 8, length);
        // Those with a small first letter may be ignored.
        const bool isNeeded = type[0] >= 'A' && type[0] <= 'Z';
        const bool isKnown =
            type == "IHDR" || type == "PLTE" || type == "tRNS" || type == "IDAT" || type == "IEND";
        if (isNeeded && !isKnown) {
            return std::nullopt;
        }
        if (isKnown && (libdeflate_crc32(0, &file[at + 4], length + 4) !=
                            bigEndian(file, at + 8 + length, 4) ||
                        !takeChunk(type, content, last != "IDAT", limits, parts))) {
            return std::nullopt;
        }
        if (type == "IEND") {
            return parts.compressed.empty() ? std::nullopt : std::optional(std::move(parts));
        }
        last = type;
        at += length + kAroundData;
    }
    return std::nullopt;
}

bool areColoursGiven(const Parts& parts) {
    const std::size_t given = parts.transparency.size();
    switch (parts.header.colorType) {
        case kGrey:
            return given == 0 || given == 2;
        case kRgb:
            return given == 0 || given == 6;
        case kPalette:
            return !parts.palette.empty() && given <= parts.palette.size() / 3;
        default:
            return given == 0;
    }
}

/// Memory that is written before it is read.
struct Scratch {
    std::unique_ptr<std::byte[]> bytes;
    std::size_t size = 0;

    explicit Scratch(std::size_t count)
        : bytes(std::make_unique_for_overwrite<std::byte[]>(count)), size(count) {}
    Bytes span() const { return {bytes.get(), size}; }
};

// The filtered rows, one behind the other, with room behind them that unfiltering may read.
std::optional<Scratch> inflate(const Parts& parts) {
    std::optional<Scratch> joined;
    Bytes compressed = parts.compressed.front();
    if (parts.compressed.size() > 1) {
        std::size_t size = 0;
        for (const Bytes part : parts.compressed) {
            size += part.size();
        }
        joined.emplace(size);
        std::byte* to = joined->bytes.get();
        for (const Bytes part : parts.compressed) {
            to = std::copy(part.begin(), part.end(), to);
        }
        compressed = joined->span();
    }
    const std::size_t size = (parts.header.rowBytes() + 1) * std::size_t(parts.header.height);
    Scratch rows(size + kUnfilterOverread);
    std::fill_n(rows.bytes.get() + size, kUnfilterOverread, std::byte(0));
    const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)>
        inflater(libdeflate_alloc_decompressor(), &libdeflate_free_decompressor);
    if (!inflater) {
        throw std::bad_alloc();
    }
    std::size_t got = 0;
    const libdeflate_result result = libdeflate_zlib_decompress(
        inflater.get(), compressed.data(), compressed.size(), rows.bytes.get(), size, &got);
    return result == LIBDEFLATE_SUCCESS && got == size ? std::optional(std::move(rows))
                                                       : std::nullopt;
}

using Rgba = std::array<std::uint8_t, 4>;

std::uint8_t toEightBits(std::uint32_t value, int bitDepth) {
    const std::uint32_t most = (1U << std::uint32_t(bitDepth)) - 1;
    return std::uint8_t((value * 255 + most / 2) / most);
}

/// One row's samples as the file has them, and as pixels.
class Row {
  public:
    Row(const Parts& parts, const std::byte* bytes) : parts_(parts), bytes_(bytes) {}

    std::uint32_t sample(std::size_t index) const {
        const auto depth = std::size_t(parts_.header.bitDepth);
        if (depth == 8) {
            return std::to_integer<std::uint32_t>(bytes_[index]);
        }
        if (depth == 16) {
            return std::to_integer<std::uint32_t>(bytes_[2 * index]) << 8U |
                   std::to_integer<std::uint32_t>(bytes_[2 * index + 1]);
        }
        const std::size_t bit = index * depth;
        const auto byte = std::to_integer<std::uint32_t>(bytes_[bit / 8]);
        return byte >> (8 - depth - bit % 8) & ((1U << depth) - 1);
    }

    /// Grey or colours, with or without alpha, with the one colour that is transparent.
    Rgba pixel(std::size_t x) const {
        const Header& header = parts_.header;
        const auto channels = std::size_t(header.channels);
        const auto value = [&](std::size_t c) { return sample(x * channels + c); };
        const auto byte = [&](std::size_t c) { return toEightBits(value(c), header.bitDepth); };
        const bool hasColours = channels >= 3;
        Rgba rgba = {byte(0), byte(hasColours ? 1 : 0), byte(hasColours ? 2 : 0), 255};
        if (channels % 2 == 0) {
            rgba[3] = byte(channels - 1);
        } else if (!parts_.transparency.empty()) {
            bool isClear = true;
            for (std::size_t c = 0; c < channels; ++c) {
                isClear = isClear && value(c) == bigEndian(parts_.transparency, 2 * c, 2);
            }
            rgba[3] = isClear ? 0 : 255;
        }
        return rgba;
    }

  private:
    const Parts& parts_;
    const std::byte* bytes_;
};

void copyRgb(const std::byte* from, std::size_t width, std::byte* to) {
    for (std::size_t x = 0; x < width; ++x) {
        to[4 * x] = from[3 * x];
        to[4 * x + 1] = from[3 * x + 1];
        to[4 * x + 2] = from[3 * x + 2];
        to[4 * x + 3] = std::byte(255);
    }
}

void writeRow(const Parts& parts, const std::byte* bytes, std::byte* to) {
    const Header& header = parts.header;
    const auto width = std::size_t(header.width);
    if (header.bitDepth == 8 && header.colorType == kRgba) {
        std::copy_n(bytes, 4 * width, to);
        return;
    }
    if (header.bitDepth == 8 && header.colorType == kRgb && parts.transparency.empty()) {
        copyRgb(bytes, width, to);
        return;
    }
    const Row row(parts, bytes);
    for (std::size_t x = 0; x < width; ++x) {
        const Rgba rgba = row.pixel(x);
        std::copy_n(reinterpret_cast<const std::byte*>(rgba.data()), 4, to + 4 * x);
    }
}

// False where an index names no entry of the palette.
bool writePaletteRow(const Parts& parts, const std::byte* bytes, std::byte* to) {
    const Row row(parts, bytes);
    for (std::size_t x = 0; x < std::size_t(parts.header.width); ++x) {
        const std::size_t entry = row.sample(x);
        if (3 * entry >= parts.palette.size()) {
            return false;
        }
        std::copy_n(parts.palette.begin() + std::ptrdiff_t(3 * entry), 3, to + 4 * x);
        to[4 * x + 3] =
            entry < parts.transparency.size() ? parts.transparency[entry] : std::byte(255);
    }
    return true;
}

bool writeRows(const Parts& parts, std::byte* rows, RawBytes& pixels) {
    const Header& header = parts.header;
    const std::size_t rowBytes = header.rowBytes();
    const std::vector<std::byte> above(rowBytes + kUnfilterOverread);
    const std::byte* previous = above.data();
    const std::size_t pixelBytes = std::max<std::size_t>(1, header.bitsPerPixel() / 8);
    for (std::size_t y = 0; y < std::size_t(header.height); ++y) {
        std::byte* const row = rows + y * (rowBytes + 1) + 1;
        if (!unfilterRow(std::to_integer<int>(row[-1]), pixelBytes, previous, row, rowBytes)) {
            return false;
        }
        previous = row;
        std::byte* const to = &pixels[y * std::size_t(header.width) * 4];
        if (header.colorType != kPalette) {
            writeRow(parts, row, to);
        } else if (!writePaletteRow(parts, row, to)) {
            return false;
        }
    }
    return true;
}

}  // namespace

std::optional<Image> decodePlainPng(Bytes encoded, const ImageLimits& limits) {
    const std::optional<Parts> parts = readParts(encoded, limits);
    if (!parts || !areColoursGiven(*parts)) {
        return std::nullopt;
    }
    const std::optional<Scratch> rows = inflate(*parts);
    if (!rows) {
        return std::nullopt;
    }
    Image image;
    image.width = parts->header.width;
    image.height = parts->header.height;
    image.pixels = RawBytes(std::size_t(image.width) * std::size_t(image.height) * 4);
    return writeRows(*parts, rows->bytes.get(), image.pixels) ? std::optional(std::move(image))
                                                              : std::nullopt;
}

}  // namespace ribalta
