// The one line of an error: its file, its place, its message.

#include "base/error.h"

#include <gtest/gtest.h>

#include "base/report.h"

namespace ribalta {
namespace {

TEST(Place, TextLeavesOutWhatIsEmpty) {
    EXPECT_EQ((Place{"a.gltf", "/meshes/3"}).text(), "a.gltf: /meshes/3");
    EXPECT_EQ((Place{"a.gltf", ""}).text(), "a.gltf");
    EXPECT_EQ((Place{"", "/meshes/3"}).text(), "/meshes/3");
    EXPECT_EQ(Place{}.text(), "");
}

TEST(Place, KeysAreEscapedAsInRfc6901) {
    const Place root{"a.gltf", ""};
    EXPECT_EQ(root.at("meshes").at(3).at("name").pointer, "/meshes/3/name");
    EXPECT_EQ(root.at("a/b").pointer, "/a~1b");
    EXPECT_EQ(root.at("m~n").pointer, "/m~0n");
    EXPECT_EQ(root.at("~1").pointer, "/~01") << "not mistaken for a slash";
    EXPECT_EQ(root.at("").pointer, "/");
    EXPECT_EQ(root.at("x").file, "a.gltf");
}

TEST(Error, IsOneLineWhateverTheFileHolds) {
    const Error error(ErrorKind::kBadInput, {"a\nb.gltf", "/x\x1b[31m"}, "tab\there\r\n");
    EXPECT_STREQ(error.what(), "a b.gltf: /x [31m: tab here  ");
}

TEST(Error, KeepsWordsOfOtherLanguages) {
    EXPECT_STREQ(Error(ErrorKind::kBadInput, {"b\xC3\xBChne.gltf", ""}, "broken").what(),
                 "b\xC3\xBChne.gltf: broken");
}

TEST(Error, KindIsTheExitCode) {
    EXPECT_EQ(Error(ErrorKind::kJobFailed, {}, "x").exitCode(), 1);
    EXPECT_EQ(Error(ErrorKind::kUsage, {}, "x").exitCode(), 2);
    EXPECT_EQ(Error(ErrorKind::kBadInput, {}, "x").exitCode(), 3);
    EXPECT_EQ(Error(ErrorKind::kNoOpenGL, {}, "x").exitCode(), 4);
    EXPECT_STREQ(Error(ErrorKind::kUsage, {}, "x").what(), "x");
}

TEST(Report, KeepsEntriesInOrder) {
    Report report;
    report.ignored({"a.gltf", "/animations"}, "not drawn");
    report.repaired({"a.gltf", "/meshes/0"}, "normals made");
    report.hint({"a.gltf", ""}, "no lamps");
    ASSERT_EQ(report.entries().size(), 3U);
    EXPECT_STREQ(name(report.entries()[0].kind), "ignored");
    EXPECT_STREQ(name(report.entries()[1].kind), "repaired");
    EXPECT_STREQ(name(report.entries()[2].kind), "hint");
    EXPECT_EQ(report.entries()[1].place.pointer, "/meshes/0");
}

}  // namespace
}  // namespace ribalta
