// Every kind of picture that is decoded, and that its channels mean what image.h says.

#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/parallel_for.h"
#include "base/read_file.h"
#include "image/read_image.h"
#include "support/make_png.h"
#include "support/test_folder.h"

namespace ribalta {
namespace {

using test::makePng;
using test::PngParts;
using Rgba = std::array<int, 4>;

std::filesystem::path dataFile(const std::string& name) {
    return std::filesystem::path(RIBALTA_SOURCE_DIR) / "tests/unit/image/data" / name;
}

Image decodeFile(const std::string& name) {
    return decodeImage(readFile(dataFile(name)), {name, ""});
}

Rgba pixel(const Image& image, int x, int y) {
    Rgba result{};
    for (int c = 0; c < 4; ++c) {
        result[std::size_t(c)] =
            std::to_integer<int>(image.pixels.at(std::size_t((y * image.width + x) * 4 + c)));
    }
    return result;
}

std::array<float, 4> floatPixel(const Image& image, int x, int y) {
    std::array<float, 4> result{};
    std::memcpy(result.data(), &image.pixels.at(std::size_t(y * image.width + x) * 16), 16);
    return result;
}

TEST(DecodeImage, RgbaPngKeepsColoursUnderTransparency) {
    const std::string row{'\xC8', '\x64', '\x32', '\0', '\x0A', '\x14', '\x1E', '\x80'};
    const Image image = decodeImage(makePng({.width = 2, .rows = {row}}), {"a.png", ""});
    EXPECT_EQ(image.name, "a.png");
    EXPECT_EQ(image.width, 2);
    EXPECT_EQ(image.height, 1);
    EXPECT_EQ(image.type, Image::Type::kUint8);
    ASSERT_EQ(image.pixels.size(), 8U);
    EXPECT_EQ(pixel(image, 0, 0), (Rgba{200, 100, 50, 0}));
    EXPECT_EQ(pixel(image, 1, 0), (Rgba{10, 20, 30, 128}));
}

TEST(DecodeImage, RgbPngIsOpaqueAndItsRowsStartAtTheTop) {
    const Image image = decodeImage(
        makePng(
            {.width = 1, .height = 2, .colorType = 2, .rows = {"\x01\x02\x03", "\x04\x05\x06"}}),
        {});
    EXPECT_EQ(pixel(image, 0, 0), (Rgba{1, 2, 3, 255}));
    EXPECT_EQ(pixel(image, 0, 1), (Rgba{4, 5, 6, 255}));
}

TEST(DecodeImage, GreyIsSpread) {
    const Image grey = decodeImage(makePng({.width = 2, .colorType = 0, .rows = {"\x11\x63"}}), {});
    EXPECT_EQ(pixel(grey, 1, 0), (Rgba{99, 99, 99, 255}));
    const Image withAlpha =
        decodeImage(makePng({.width = 1, .colorType = 4, .rows = {"\x63\x07"}}), {});
    EXPECT_EQ(pixel(withAlpha, 0, 0), (Rgba{99, 99, 99, 7}));
}

TEST(DecodeImage, OneBitGreyReachesWhite) {
    const Image image =
        decodeImage(makePng({.width = 8, .bitDepth = 1, .colorType = 0, .rows = {"\xA0"}}), {});
    EXPECT_EQ(pixel(image, 0, 0), (Rgba{255, 255, 255, 255}));
    EXPECT_EQ(pixel(image, 1, 0), (Rgba{0, 0, 0, 255}));
    EXPECT_EQ(pixel(image, 2, 0), (Rgba{255, 255, 255, 255}));
}

TEST(DecodeImage, PaletteWithTransparentEntry) {
    PngParts parts{.width = 2, .colorType = 3, .rows = {std::string("\x01\x00", 2)}};
    parts.palette = "\x0A\x14\x1E\x28\x32\x3C";
    parts.transparency = std::string("\xFF\x40", 2);
    const Image image = decodeImage(makePng(parts), {});
    EXPECT_EQ(pixel(image, 0, 0), (Rgba{40, 50, 60, 64}));
    EXPECT_EQ(pixel(image, 1, 0), (Rgba{10, 20, 30, 255}));
}

TEST(DecodeImage, SixteenBitsAreRoundedToTheNearestOfEight) {
    // 0x0080 is 0.498 of a step of eight bits, 0x0081 is 0.502.
    const std::string row("\x00\x80\x00\x81\xFF\xFF\xFF\x7F\xFF\x7E\x00\x00\x12\x34\xFF\xFF", 16);
    const Image image =
        decodeImage(makePng({.width = 2, .bitDepth = 16, .colorType = 6, .rows = {row}}), {});
    EXPECT_EQ(image.type, Image::Type::kUint8);
    EXPECT_EQ(pixel(image, 0, 0), (Rgba{0, 1, 255, 255}));
    EXPECT_EQ(pixel(image, 1, 0), (Rgba{254, 0, 18, 255}));
}

TEST(DecodeImage, ColourProfilesAndGammaAreIgnored) {
    PngParts parts{.width = 1, .colorType = 2, .rows = {"\x32\x64\x96"}};
    parts.extra = {{"gAMA", std::string("\x00\x01\x86\xA0", 4)}, {"iCCP", "no profile at all"}};
    testing::internal::CaptureStderr();
    const Image image = decodeImage(makePng(parts), {});
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(pixel(image, 0, 0), (Rgba{50, 100, 150, 255}));
}

TEST(DecodeImage, WebpKeepsColoursUnderTransparency) {
    const Image image = decodeFile("alpha.webp");  // lossless: pixel i is 250 - i, 3 i, 7, 17 i
    ASSERT_EQ(image.width * image.height, 16);
    for (int i = 0; i < 16; ++i) {
        EXPECT_EQ(pixel(image, i % 4, i / 4), (Rgba{250 - i, 3 * i, 7, 17 * i})) << i;
    }
}

TEST(DecodeImage, Jpeg) {
    const Image image = decodeFile("colour.jpg");  // left red, right dark; bottom blue
    ASSERT_EQ(image.width, 16);
    ASSERT_EQ(image.height, 8);
    const Rgba topLeft = pixel(image, 1, 0);
    EXPECT_NEAR(topLeft[0], 200, 4);
    EXPECT_NEAR(topLeft[1], 100, 4);
    EXPECT_NEAR(topLeft[2], 30, 4);
    EXPECT_NEAR(pixel(image, 14, 0)[0], 40, 4);
    EXPECT_NEAR(pixel(image, 1, 7)[2], 220, 4);
    EXPECT_EQ(topLeft[3], 255);
    EXPECT_EQ(pixel(decodeFile("grey.jpg"), 3, 3), (Rgba{77, 77, 77, 255}));
}

TEST(DecodeImage, SixteenBitTiffKeepsStraightAlpha) {
    const Image image = decodeFile("alpha16.tif");  // pixel i: 32768, 4000 i, 65535, 9362 i
    EXPECT_EQ(pixel(image, 0, 0), (Rgba{128, 0, 255, 0}));
    EXPECT_EQ(pixel(image, 3, 0), (Rgba{128, 47, 255, 109}));
}

TEST(DecodeImage, HdrIsFloatAndMayBeBrighterThanOne) {
    const Image image = decodeFile("bright.hdr");
    ASSERT_EQ(image.type, Image::Type::kFloat32);
    ASSERT_EQ(image.pixels.size(), 2U * 16);
    const auto bright = floatPixel(image, 0, 0);
    EXPECT_NEAR(bright[0], 1000.0F, 4.0F);
    EXPECT_NEAR(bright[1], 10.0F, 4.0F);
    EXPECT_EQ(bright[3], 1.0F);
    EXPECT_EQ(floatPixel(image, 1, 0)[0], 0.0F);
}

TEST(DecodeImage, ExrFillsItsDisplayWindowFiniteAndUnpremultiplied) {
    // 2 x 2 pixels stored at (1, 1) of 4 x 3: 1 2 3 1, 0.25 0.5 0.75 0.5, inf -inf nan 1, 4 5 6 0.
    const Image image = decodeFile("window.exr");
    ASSERT_EQ(image.width, 4);
    ASSERT_EQ(image.height, 3);
    using Pixel = std::array<float, 4>;
    EXPECT_EQ(floatPixel(image, 0, 0), (Pixel{0, 0, 0, 0}));
    EXPECT_EQ(floatPixel(image, 1, 1), (Pixel{1, 2, 3, 1}));
    EXPECT_EQ(floatPixel(image, 2, 1), (Pixel{0.5F, 1.0F, 1.5F, 0.5F}));
    EXPECT_EQ(floatPixel(image, 1, 2), (Pixel{65504.0F, 0.0F, 0.0F, 1.0F}));
    EXPECT_EQ(floatPixel(image, 2, 2), (Pixel{4, 5, 6, 0}));
    EXPECT_EQ(floatPixel(image, 3, 2), (Pixel{0, 0, 0, 0}));
}

TEST(DecodeImage, TheContentCountsAndNotTheName) {
    const test::TestFolder folder;
    const auto path = folder.write("really_a_jpeg.png", readFile(dataFile("colour.jpg")));
    EXPECT_EQ(decodeImage(readFile(path), {path.string(), ""}).width, 16);
    EXPECT_EQ(readFloatImage(path).width, 16);
}

TEST(DecodeImage, ManyAtOnce) {
    const std::vector<std::vector<std::byte>> files{
        readFile(dataFile("alpha.webp")), readFile(dataFile("window.exr")),
        readFile(dataFile("colour.jpg")), makePng({.width = 1, .rows = {"\x01\x02\x03\x04"}})};
    const std::array<int, 4> widths{4, 4, 16, 1};
    std::atomic<int> right = 0;
    parallelFor(200, [&](std::size_t i) {
        right += decodeImage(files[i % 4], {}).width == widths[i % 4] ? 1 : 0;
    });
    EXPECT_EQ(right, 200);
}

TEST(ReadFloatImage, GivesChannelsAsTheFileHasThem) {
    const FloatImage webp = readFloatImage(dataFile("alpha.webp"));
    EXPECT_EQ(webp.channels, (std::vector<std::string>{"R", "G", "B", "A"}));
    EXPECT_FLOAT_EQ(webp.at(1, 0, webp.channel("A")), 17.0F / 255.0F);
    const FloatImage jpeg = readFloatImage(dataFile("colour.jpg"));
    EXPECT_EQ(jpeg.channels.size(), 3U);
    EXPECT_NEAR(jpeg.at(1, 0, 0), 200.0 / 255.0, 0.02);
    const FloatImage exr = readFloatImage(dataFile("window.exr"));
    EXPECT_EQ(exr.width, 2) << "the stored pixels, not the display window";
    EXPECT_TRUE(std::isinf(exr.at(0, 1, exr.channel("R")))) << "as stored";
}

}  // namespace
}  // namespace ribalta
