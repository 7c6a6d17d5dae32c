#include "base/mapped_file.h"

#include <cstring>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sys/mman.h>

#include "support/expect_error.h"
#include "support/test_folder.h"

namespace ribalta {
namespace {

using test::expectError;
using test::TestFolder;

std::string largeText() {
    std::string text(3 * kMappedFrom + 123, 'a');
    for (std::size_t i = 0; i < text.size(); i += 1000) {
        text[i] = char('b' + i / 1000 % 20);
    }
    return text;
}

bool holds(const MappedFile& file, const std::string& text) {
    return file.bytes().size() == text.size() &&
           std::memcmp(file.bytes().data(), text.data(), text.size()) == 0;
}

TEST(MappedFile, GivesAllBytesOfLargeAndOfSmallFiles) {
    const TestFolder folder;
    const std::string text = largeText();
    const MappedFile large(folder.write("large", text));
    EXPECT_TRUE(holds(large, text));
    large.expectUnchanged();
    const MappedFile small(folder.write("small", "123"));
    EXPECT_TRUE(holds(small, "123"));
    small.expectUnchanged();
    EXPECT_TRUE(MappedFile(folder.write("empty", "")).bytes().empty());
    EXPECT_EQ(MappedFile(folder / "large", UINT64_MAX, 2 * kMappedFrom).bytes().size(),
              2 * kMappedFrom);
}

TEST(MappedFile, RefusesAsReadFileDoes) {
    const TestFolder folder;
    expectError(ErrorKind::kBadInput, {"no such file"}, [&] { MappedFile(folder / "none"); });
    expectError(ErrorKind::kBadInput, {"not a regular file"}, [] { MappedFile("/dev/zero"); });
    const std::filesystem::path large = folder.write("large", largeText());
    expectError(ErrorKind::kBadInput, {"large", "limit of 1000"}, [&] { MappedFile(large, 1000); });
}

TEST(MappedFile, ReadsZerosBehindTheEndOfAFileThatIsCut) {
    const TestFolder folder;
    const std::string text = largeText();
    const std::filesystem::path path = folder.write("large", text);
    const MappedFile file(path);
    std::filesystem::resize_file(path, 5000);
    // From several threads, as meshes and pictures are read.
    std::vector<std::jthread> readers;
    std::vector<int> sums(4, -1);
    for (int& sum : sums) {
        readers.emplace_back([&sum, &file] {
            sum = 0;
            for (const std::byte byte : file.bytes().subspan(8192)) {
                sum += int(byte);
            }
        });
    }
    readers.clear();
    EXPECT_EQ(sums, std::vector<int>(4, 0));
    EXPECT_EQ(std::memcmp(file.bytes().data(), text.data(), 5000), 0);
    expectError(ErrorKind::kBadInput, {"large", "changed while it was read"},
                [&] { file.expectUnchanged(); });
}

TEST(MappedFile, TellsThatAFileWasWrittenTo) {
    const TestFolder folder;
    const std::filesystem::path path = folder.write("large", largeText());
    const MappedFile file(path);
    std::filesystem::last_write_time(
        path, std::filesystem::last_write_time(path) + std::chrono::seconds(2));
    expectError(ErrorKind::kBadInput, {"changed while it was read"},
                [&] { file.expectUnchanged(); });
}

TEST(MappedFile, ManyAtOnceAndInOtherHandsGiveTheirBytes) {
    const TestFolder folder;
    const std::string text = largeText();
    const std::filesystem::path path = folder.write("large", text);
    for (int round = 0; round < 2; ++round) {
        std::vector<MappedFile> files;
        for (int i = 0; i < 70; ++i) {  // more than there is room for guards
            files.emplace_back(path);
        }
        MappedFile moved = std::move(files.front());
        files.front() = MappedFile(folder.write("small", "1"));
        EXPECT_TRUE(holds(moved, text));
        EXPECT_TRUE(holds(files[1], text));
        EXPECT_TRUE(holds(files.back(), text));
    }
}

// A mistake of this program's must still be seen as one.
TEST(MappedFileDeathTest, OtherBusErrorsEndTheProcess) {
    const TestFolder folder;
    const std::filesystem::path path = folder.write("large", largeText());
    const MappedFile file(path);
    const RegularFile other(folder.write("other", std::string(8192, 'x')));
    const auto touchBehindTheEnd = [&] {
        auto* const start = static_cast<volatile char*>(
            mmap(nullptr, 8192, PROT_READ, MAP_PRIVATE, other.descriptor(), 0));
        std::filesystem::resize_file(folder / "other", 0);
        std::exit(start[4096]);
    };
    EXPECT_DEATH(touchBehindTheEnd(), "");
}

}  // namespace
}  // namespace ribalta
