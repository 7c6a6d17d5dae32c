// What is decoded without OpenImageIO comes out as OpenImageIO, with libpng and libjpeg underneath,
// decodes it, byte for byte.

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/read_file.h"
#include "image/decode_jpeg.h"
#include "image/decode_png.h"
#include "image/image_codec.h"
#include "support/make_png.h"

namespace ribalta {
namespace {

using test::makePng;
using test::PngParts;

struct Kind {
    int colorType;
    int bitDepth;
    int channels;
};

constexpr Kind kKinds[] = {{0, 1, 1}, {0, 2, 1},  {0, 4, 1},  {0, 8, 1}, {0, 16, 1},
                           {2, 8, 3}, {2, 16, 3}, {3, 1, 1},  {3, 2, 1}, {3, 4, 1},
                           {3, 8, 1}, {4, 8, 2},  {4, 16, 2}, {6, 8, 4}, {6, 16, 4}};

// Random rows, every other one like the one above, each filter in turn.
PngParts randomPng(const Kind& kind, int width, int height, std::mt19937& random) {
    PngParts parts;
    parts.width = std::uint32_t(width);
    parts.height = std::uint32_t(height);
    parts.bitDepth = kind.bitDepth;
    parts.colorType = kind.colorType;
    const int bytes = (width * kind.channels * kind.bitDepth + 7) / 8;
    for (int y = 0; y < height; ++y) {
        std::string row(std::size_t(bytes), '\0');
        std::generate(row.begin(), row.end(), [&] { return char(random() % 256); });
        if (y % 2 == 1) {
            row = parts.rows.back();
            row[random() % row.size()] ^= char(1);
        }
        parts.rows.push_back(row);
        parts.filters.push_back(int(random() % 5));
    }
    if (kind.colorType == 3) {
        parts.palette.resize(std::size_t(3) << std::size_t(kind.bitDepth));
        std::generate(parts.palette.begin(), parts.palette.end(),
                      [&] { return char(random() % 256); });
    }
    return parts;
}

// The transparency that a kind may have: of some palette entries, or of the first pixel's colour.
std::string transparencyOf(const PngParts& parts) {
    if (parts.colorType == 3) {
        return std::string("\x00\x80", 2);
    }
    const std::string& row = parts.rows.front();
    const std::size_t channels = parts.colorType == 2 ? 3 : 1;
    std::string color;
    for (std::size_t c = 0; c < channels; ++c) {
        if (parts.bitDepth == 16) {
            color += row.substr(2 * c, 2);
        } else {
            const auto first = static_cast<unsigned char>(row[c]);
            color += {'\0', char(first >> (8 - parts.bitDepth))};
        }
    }
    return color;
}

Image decodedByModule(const std::vector<std::byte>& encoded, ImageFormat format) {
    Image image;
    EXPECT_EQ(imageCodec().decode(encoded, format, ImageLimits{}, image), "");
    return image;
}

void expectAlike(const std::optional<Image>& image, const Image& truth) {
    ASSERT_TRUE(image);
    EXPECT_EQ(image->width, truth.width);
    EXPECT_EQ(image->height, truth.height);
    EXPECT_EQ(image->type, truth.type);
    EXPECT_EQ(image->pixels, truth.pixels);
}

TEST(DecodePlainPng, EveryKindAsLibpng) {
    std::mt19937 random(7);
    for (const Kind& kind : kKinds) {
        for (const int width : {1, 2, 3, 7, 16, 61}) {
            SCOPED_TRACE("colour type " + std::to_string(kind.colorType) + ", " +
                         std::to_string(kind.bitDepth) + " bits, width " + std::to_string(width));
            PngParts parts = randomPng(kind, width, 23, random);
            const std::vector<std::byte> plain = makePng(parts);
            expectAlike(decodePlainPng(plain, {}), decodedByModule(plain, ImageFormat::kPng));
            if (kind.colorType > 3) {
                continue;
            }
            parts.transparency = transparencyOf(parts);
            const std::vector<std::byte> clear = makePng(parts);
            const std::optional<Image> image = decodePlainPng(clear, {});
            expectAlike(image, decodedByModule(clear, ImageFormat::kPng));
            EXPECT_TRUE(kind.colorType == 3 || image->pixels[3] == std::byte(0));
        }
    }
}

TEST(DecodePlainPng, LeavesWhatIsOddToTheModule) {
    std::mt19937 random(8);
    PngParts parts = randomPng({6, 8, 4}, 5, 4, random);
    const std::vector<std::byte> whole = makePng(parts);
    ASSERT_TRUE(decodePlainPng(whole, {}));
    for (std::size_t i = 8; i < whole.size(); ++i) {
        std::vector<std::byte> damaged = whole;
        damaged[i] ^= std::byte(4);
        EXPECT_FALSE(decodePlainPng(damaged, {})) << "byte " << i;
        EXPECT_FALSE(decodePlainPng(std::span(whole).first(i), {})) << i << " bytes";
    }
    EXPECT_FALSE(decodePlainPng(whole, {.maxSide = 4}));
    parts.rows.pop_back();
    EXPECT_FALSE(decodePlainPng(makePng(parts), {})) << "a row is missing";

    PngParts palette = randomPng({3, 8, 1}, 4, 1, random);
    palette.rows = {std::string("\x00\x01\x02\x03", 4)};
    palette.palette.resize(9);
    EXPECT_FALSE(decodePlainPng(makePng(palette), {})) << "no such entry";
    palette.rows = {std::string("\x00\x01\x02\x02", 4)};
    EXPECT_TRUE(decodePlainPng(makePng(palette), {}));
    palette.palette.clear();
    EXPECT_FALSE(decodePlainPng(makePng(palette), {})) << "no palette";
    palette.colorType = 0;
    palette.transparency = "x";
    EXPECT_FALSE(decodePlainPng(makePng(palette), {})) << "half a transparent colour";
    palette.transparency.clear();
    palette.extra = {{"teSt", "may be ignored"}};
    EXPECT_TRUE(decodePlainPng(
        makePng(PngParts{palette.width, 1, 8, 0, palette.rows, {}, "", "", palette.extra}), {}));
    palette.extra = {{"TEST", "must be understood"}};
    EXPECT_FALSE(decodePlainPng(
        makePng(PngParts{palette.width, 1, 8, 0, palette.rows, {}, "", "", palette.extra}), {}));
}

TEST(DecodePlainJpeg, AsLibjpeg) {
    for (const char* name : {"colour.jpg", "grey.jpg"}) {
        const std::vector<std::byte> encoded =
            readFile(std::string(RIBALTA_SOURCE_DIR "/tests/unit/image/data/") + name);
        expectAlike(decodePlainJpeg(encoded, {}), decodedByModule(encoded, ImageFormat::kJpeg));
        EXPECT_FALSE(decodePlainJpeg(encoded, {.maxSide = 1}));
        EXPECT_FALSE(decodePlainJpeg(std::span(encoded).first(20), {}));
    }
}

}  // namespace
}  // namespace ribalta
