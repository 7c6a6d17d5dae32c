// Pictures come back as they were written, and a failed write leaves what was there.

#include "image/write_image.h"

#include <csignal>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "base/read_file.h"
#include "image/read_image.h"
#include "support/expect_error.h"
#include "support/test_folder.h"

namespace ribalta {
namespace {

using test::expectError;
using test::TestFolder;

// While it lives no file can grow over a few bytes: what a full disk looks like to a program.
class FullDisk {
  public:
    FullDisk() {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit small{16, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

  private:
    rlimit before_{};
    void (*handler_)(int) = nullptr;
};

FloatImage layeredImage() {
    FloatImage image{3, 2, {"R", "G", "B", "beams.R", "beams.G", "beams.B", "Z"}, {}};
    for (int i = 0; i < 3 * 2 * 7; ++i) {
        image.values.push_back(static_cast<float>(i) * 1.1F - 7.0F);
    }
    image.values[6] = std::numeric_limits<float>::infinity();
    image.values[7] = 1.0e30F;
    return image;
}

std::vector<std::uint8_t> ramp(int width, int height) {
    std::vector<std::uint8_t> rgb;
    for (int i = 0; i < width * height * 3; ++i) {
        rgb.push_back(static_cast<std::uint8_t>(i * 7));
    }
    return rgb;
}

bool contains(const std::vector<std::byte>& bytes, std::string_view text) {
    const std::string_view all(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return all.find(text) != std::string_view::npos;
}

TEST(WritePng, ComesBackBitByBit) {
    const TestFolder folder;
    const std::vector<std::uint8_t> rgb = ramp(5, 3);
    writePng(folder / "a.png", 5, 3, rgb);
    EXPECT_EQ(folder.entryCount(), 1U);
    const std::vector<std::byte> encoded = readFile(folder / "a.png");
    EXPECT_TRUE(contains(encoded, "sRGB"));
    const Image image = decodeImage(encoded, {});
    ASSERT_EQ(image.width, 5);
    ASSERT_EQ(image.height, 3);
    for (std::size_t i = 0; i < 15; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            ASSERT_EQ(std::to_integer<int>(image.pixels[4 * i + c]), rgb[3 * i + c]);
        }
    }
}

TEST(WriteExr, ComesBackBitByBitWithItsLayers) {
    const TestFolder folder;
    const FloatImage written = layeredImage();
    writeExr(folder / "a.exr", written);
    EXPECT_TRUE(contains(readFile(folder / "a.exr"), "beams.G"));
    const FloatImage read = readFloatImage(folder / "a.exr");
    ASSERT_EQ(read.width, 3);
    ASSERT_EQ(read.height, 2);
    ASSERT_EQ(read.channels.size(), written.channels.size());
    for (const std::string& name : written.channels) {
        ASSERT_GE(read.channel(name), 0) << name;
        for (int i = 0; i < 6; ++i) {
            EXPECT_EQ(read.at(i % 3, i / 3, read.channel(name)),
                      written.at(i % 3, i / 3, written.channel(name)));
        }
    }
}

TEST(WriteExr, IsTheSameFileEachTime) {
    const TestFolder folder;
    writeExr(folder / "a.exr", layeredImage());
    writeExr(folder / "b.exr", layeredImage());
    EXPECT_EQ(readFile(folder / "a.exr"), readFile(folder / "b.exr"));
}

TEST(WriteImage, ReplacesAnOlderFile) {
    const TestFolder folder;
    folder.write("a.png", "old");
    writePng(folder / "a.png", 5, 3, ramp(5, 3));
    EXPECT_EQ(readFloatImage(folder / "a.png").width, 5);
    EXPECT_EQ(folder.entryCount(), 1U);
}

TEST(WriteImage, FullDiskKeepsTheOlderFileAndLeavesNoOther) {
    const TestFolder folder;
    for (const char* name : {"a.png", "a.exr"}) {
        folder.write(name, "old");
        expectError(ErrorKind::kJobFailed, {name, "cannot be written", "too large"}, [&] {
            const FullDisk full;
            if (std::string(name) == "a.png") {
                writePng(folder / name, 5, 3, ramp(5, 3));
            } else {
                writeExr(folder / name, layeredImage());
            }
        });
        EXPECT_EQ(readFile(folder / name).size(), 3U);
    }
    EXPECT_EQ(folder.entryCount(), 2U);
}

TEST(WriteImage, NamesTheTargetWhereTheFolderCannotBeUsed) {
    const TestFolder folder;
    folder.write("file", "x");
    const auto write = [](const std::filesystem::path& path) { writePng(path, 5, 3, ramp(5, 3)); };
    expectError(ErrorKind::kJobFailed, {"missing/a.png", "make the folder first"},
                [&] { write(folder / "missing/a.png"); });
    expectError(ErrorKind::kJobFailed, {"file/a.png", "cannot be written"},
                [&] { write(folder / "file/a.png"); });
    expectError(ErrorKind::kJobFailed, {"cannot be written", "folder"},
                [&] { write(folder.path()); });
    expectError(ErrorKind::kJobFailed, {"/proc/a.png", "cannot be written"},
                [&] { write("/proc/a.png"); });
    EXPECT_EQ(folder.entryCount(), 1U);
}

}  // namespace
}  // namespace ribalta
