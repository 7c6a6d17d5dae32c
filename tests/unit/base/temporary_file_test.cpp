#include "base/temporary_file.h"

#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "support/expect_error.h"
#include "support/test_folder.h"

namespace ribalta {
namespace {

using test::expectError;
using test::TestFolder;

std::string contentOf(const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

TEST(TemporaryFile, TargetIsUntouchedUntilCommit) {
    const TestFolder folder;
    const std::filesystem::path target = folder.write("a.exr", "old");
    TemporaryFile temporary(target);
    EXPECT_EQ(temporary.path().extension(), ".exr");
    EXPECT_EQ(temporary.path().parent_path(), std::filesystem::canonical(folder.path()));
    std::ofstream(temporary.path()) << "new";
    EXPECT_EQ(contentOf(target), "old");
    temporary.commit();
    EXPECT_EQ(contentOf(target), "new");
    EXPECT_EQ(folder.entryCount(), 1U);
}

TEST(TemporaryFile, UncommittedIsRemoved) {
    const TestFolder folder;
    {
        const TemporaryFile temporary(folder / "a.png");
        std::ofstream(temporary.path()) << "new";
        EXPECT_EQ(folder.entryCount(), 1U);
    }
    EXPECT_EQ(folder.entryCount(), 0U);
}

TEST(TemporaryFile, OutputHasTheRightsOfAnyNewFile) {
    const TestFolder folder;
    const mode_t before = umask(022);
    writeFileAtomically(folder / "a.json", "{}");
    umask(before);
    struct stat status {};
    ASSERT_EQ(stat((folder / "a.json").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0644U);
}

TEST(TemporaryFile, RefusesTargetsThatAreNoFiles) {
    const TestFolder folder;
    folder.write("file", "x");
    expectError(ErrorKind::kJobFailed, {"cannot be written", "folder"},
                [&] { const TemporaryFile temporary(folder.path()); });
    expectError(ErrorKind::kJobFailed, {"/dev/null", "not a regular file"},
                [] { writeFileAtomically("/dev/null", "x"); });
    expectError(ErrorKind::kJobFailed, {"missing/a", "make the folder first"},
                [&] { const TemporaryFile temporary(folder / "missing/a"); });
    expectError(ErrorKind::kJobFailed, {"file/a", "cannot be written"},
                [&] { const TemporaryFile temporary(folder / "file/a"); });
    EXPECT_EQ(folder.entryCount(), 1U);
}

TEST(TemporaryFile, AllUnfinishedOnesCanBeRemovedAtOnce) {
    const TestFolder folder;
    folder.write("a.png", "old");
    const TemporaryFile one(folder / "a.png");
    {
        TemporaryFile finished(folder / "b.png");
        finished.commit();
    }
    const TemporaryFile two(folder / "c.png");
    ASSERT_EQ(folder.entryCount(), 4U);
    removeTemporaryFiles();
    EXPECT_EQ(folder.entryCount(), 2U);
    EXPECT_EQ(contentOf(folder / "a.png"), "old");
    EXPECT_TRUE(std::filesystem::exists(folder / "b.png"));
}

TEST(TemporaryFile, FollowsLinks) {
    const TestFolder folder;
    folder.write("real.png", "old");
    std::filesystem::create_symlink("real.png", folder / "link.png");
    writeFileAtomically(folder / "link.png", "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.png"));
    EXPECT_EQ(contentOf(folder / "real.png"), "new");
}

}  // namespace
}  // namespace ribalta
