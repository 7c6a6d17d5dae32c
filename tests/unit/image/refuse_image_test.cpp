// Pictures that cannot be used: each is refused with its place, before memory is taken.

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/read_file.h"
#include "image/read_image.h"
#include "support/expect_error.h"
#include "support/make_png.h"

namespace ribalta {
namespace {

using test::expectError;
using test::makePng;

const Place kPlace{"stage.gltf", "/images/3"};

std::vector<std::byte> readDataFile(const std::string& name) {
    return readFile(std::string(RIBALTA_SOURCE_DIR "/tests/unit/image/data/") + name);
}

void expectRefused(std::span<const std::byte> encoded, const std::vector<std::string>& words,
                   const ImageLimits& limits = {}) {
    std::vector<std::string> all{"stage.gltf: /images/3: "};
    all.insert(all.end(), words.begin(), words.end());
    expectError(ErrorKind::kBadInput, all, [&] { decodeImage(encoded, kPlace, limits); });
}

std::vector<std::byte> bytesOf(std::string_view text) {
    const auto* data = reinterpret_cast<const std::byte*>(text.data());
    return {data, data + text.size()};
}

TEST(RefuseImage, WhatIsNoPicture) {
    expectRefused({}, {"0 bytes", "PNG"});
    expectRefused(bytesOf("hello"), {"no known picture format", "PNG, JPEG"});
    expectRefused(bytesOf("\xabKTX 20\xbb\r\n"), {"KTX2"});
    expectRefused(bytesOf("GIF89a"), {"GIF"});
    expectRefused(bytesOf("<svg/>"), {"SVG"});
}

TEST(RefuseImage, OnlyAMagicNumber) {
    for (const char* magic :
         {"\x89PNG\r\n\x1a\n", "\xff\xd8\xff", "RIFFxxxxWEBP", "v/1\x01", "#?RADIANCE"}) {
        expectRefused(bytesOf(magic), {"save it anew"});
    }
    expectRefused(bytesOf({"II*\0", 4}), {"save it anew"});
}

class RefuseTruncated : public testing::TestWithParam<const char*> {};

TEST_P(RefuseTruncated, AtAnyLength) {
    const std::vector<std::byte> whole = readDataFile(GetParam());
    ASSERT_NO_THROW(decodeImage(whole, kPlace));
    const std::size_t steps = std::min<std::size_t>(whole.size() - 1, 40);
    for (std::size_t i = 1; i < steps; ++i) {
        const std::size_t size = whole.size() * i / steps;
        SCOPED_TRACE(std::to_string(size) + " bytes of " + std::to_string(whole.size()));
        expectRefused(std::span(whole).first(size), {});
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, RefuseTruncated,
                         testing::Values("alpha.webp", "alpha16.tif", "bright.hdr", "colour.jpg",
                                         "grey.jpg", "window.exr"),
                         [](const auto& format) {
                             std::string name = format.param;
                             std::replace(name.begin(), name.end(), '.', '_');
                             return name;
                         });

TEST(RefuseImage, TruncatedPng) {
    const std::vector<std::byte> whole = makePng({.width = 1, .rows = {"\x01\x02\x03\x04"}});
    for (std::size_t size = 8; size < whole.size(); ++size) {
        expectRefused(std::span(whole).first(size), {"truncated PNG"});
    }
}

TEST(RefuseImage, DamagedPng) {
    std::vector<std::byte> damaged = makePng({.width = 1, .rows = {"\x01\x02\x03\x04"}});
    damaged[damaged.size() - 24] ^= std::byte(1);  // in the compressed pixels
    expectRefused(damaged, {"damaged PNG", "IDAT"});
}

TEST(RefuseImage, PngWithFewerPixelsThanItSays) {
    expectRefused(makePng({.width = 1, .height = 5, .rows = {"\x01\x02\x03\x04"}}),
                  {"broken or truncated png"});
}

TEST(RefuseImage, OverTheLimits) {
    // Only the headers are this large: reaching for the pixels would fail in another way.
    const auto wide = makePng({.width = 40000, .height = 1, .rows = {"x"}});
    expectRefused(wide, {"40000 x 1", "limit of 32768"});
    const auto many = makePng({.width = 20000, .height = 20000, .rows = {"x"}});
    expectRefused(many, {"20000 x 20000", "268435456 in all", "scale it down"});
    const ImageLimits small{.maxSide = 3, .maxPixels = 1000};
    for (const char* name : {"alpha.webp", "alpha16.tif", "colour.jpg"}) {
        expectRefused(readDataFile(name), {"limit of 3 a side"}, small);
    }
    // The stored pixels are within the limits here, the display window is not.
    expectRefused(readDataFile("window.exr"), {"4 x 3"}, small);
}

TEST(RefuseImage, AtTheLimitIsFine) {
    EXPECT_NO_THROW(
        decodeImage(readDataFile("alpha.webp"), kPlace, {.maxSide = 4, .maxPixels = 16}));
    expectRefused(readDataFile("alpha.webp"), {"4 x 4"}, {.maxSide = 4, .maxPixels = 15});
}

TEST(ReadFloatImage, NamesTheFile) {
    expectError(ErrorKind::kBadInput, {"/nowhere/a.exr", "no such file"},
                [] { readFloatImage("/nowhere/a.exr"); });
    expectError(ErrorKind::kBadInput, {"CMakeLists.txt", "no known picture format"},
                [] { readFloatImage(RIBALTA_SOURCE_DIR "/CMakeLists.txt"); });
}

}  // namespace
}  // namespace ribalta
