#include "base/read_file.h"

#include <cstring>
#include <string>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "support/expect_error.h"
#include "support/test_folder.h"

namespace ribalta {
namespace {

using test::expectError;
using test::TestFolder;

TEST(ReadFile, GivesAllBytes) {
    const TestFolder folder;
    const std::string content("a\0b\r\n\xff", 6);
    const std::vector<std::byte> bytes = readFile(folder.write("a", content));
    ASSERT_EQ(bytes.size(), content.size());
    EXPECT_EQ(std::memcmp(bytes.data(), content.data(), content.size()), 0);
    EXPECT_TRUE(readFile(folder.write("empty", "")).empty());
}

TEST(ReadFile, RefusesWhatIsNoRegularFile) {
    const TestFolder folder;
    expectError(ErrorKind::kBadInput, {folder.path().string(), "not a regular file"},
                [&] { readFile(folder.path()); });
    expectError(ErrorKind::kBadInput, {"/dev/null", "not a regular file"},
                [] { readFile("/dev/null"); });
    const std::filesystem::path pipe = folder / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    expectError(ErrorKind::kBadInput, {"pipe", "not a regular file"}, [&] { readFile(pipe); });
}

TEST(ReadFile, RefusesWhatIsMissing) {
    const TestFolder folder;
    const std::filesystem::path file = folder.write("file", "x");
    for (const auto& path : {folder / "missing", file / "below", std::filesystem::path()}) {
        expectError(ErrorKind::kBadInput, {"no such file"}, [&] { readFile(path); });
    }
    std::filesystem::create_symlink("nowhere", folder / "dangling");
    expectError(ErrorKind::kBadInput, {"dangling", "no such file"},
                [&] { readFile(folder / "dangling"); });
}

TEST(ReadFile, RefusesWhatIsTooLarge) {
    const TestFolder folder;
    const std::filesystem::path file = folder.write("a", "12345");
    EXPECT_EQ(readFile(file, 5).size(), 5U);
    expectError(ErrorKind::kBadInput, {"5 bytes", "limit of 4"}, [&] { readFile(file, 4); });
}

}  // namespace
}  // namespace ribalta
