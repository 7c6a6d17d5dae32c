// The picture libraries are opened when the first picture needs them, and not before.

#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "base/read_file.h"
#include "image/read_image.h"

namespace ribalta {
namespace {

bool isLoaded(const std::string& library) {
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
        if (line.find(library) != std::string::npos) {
            return true;
        }
    }
    return false;
}

TEST(ImageModule, IsOpenedOnFirstUse) {
    ASSERT_TRUE(isLoaded("libc.so")) << "/proc/self/maps cannot be read: the test sees nothing";
    EXPECT_FALSE(isLoaded("libOpenImageIO.so"));
    EXPECT_FALSE(isLoaded("ribalta_image_io.so"));

    const auto decode = [](const std::string& name) {
        const std::string file = RIBALTA_SOURCE_DIR "/tests/unit/image/data/" + name;
        return decodeImage(readFile(file), {file, ""});
    };
    EXPECT_EQ(decode("grey.jpg").width, 16);
    EXPECT_FALSE(isLoaded("libOpenImageIO.so"));
    EXPECT_FALSE(isLoaded("ribalta_image_io.so"));

    EXPECT_GT(decode("alpha16.tif").width, 0);
    EXPECT_TRUE(isLoaded("libOpenImageIO.so"));
    EXPECT_TRUE(isLoaded("ribalta_image_io.so"));
}

}  // namespace
}  // namespace ribalta
