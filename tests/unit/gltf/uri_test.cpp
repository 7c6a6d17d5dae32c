// data: URIs and paths.
#include <string>

#include <gtest/gtest.h>

#include "gltf/read_uri.h"
#include "support/expect_error.h"
#include "support/test_folder.h"

namespace ribalta::test {
namespace {

std::string decoded(std::string_view uri) {
    const std::vector<std::byte> bytes = gltf::decodeDataUri(uri, {"f", "/p"});
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

TEST(UriTest, DataUrisOfEveryForm) {
    EXPECT_EQ(decoded("data:;base64,aGF6ZQ=="), "haze");
    EXPECT_EQ(decoded("data:application/octet-stream;base64,aGF6ZQ"), "haze");
    EXPECT_EQ(decoded("DATA:text/plain;charset=utf-8;BASE64,aGF6ZQ=="), "haze");
    EXPECT_EQ(decoded("data:;base64,aGF6ZQ%3D%3D"), "haze");
    EXPECT_EQ(decoded("data:,ha%7Ae"), "haze");
    EXPECT_EQ(decoded("data:;base64,"), "");
    EXPECT_EQ(decoded("data:;base64,_-8="), "\xff\xef");
    EXPECT_TRUE(gltf::isDataUri("Data:,x"));
    EXPECT_FALSE(gltf::isDataUri("date.bin"));
}

TEST(UriTest, BrokenDataUrisAreRefused) {
    expectError(ErrorKind::kBadInput, {"/p", "comma"}, [] { decoded("data:;base64"); });
    expectError(ErrorKind::kBadInput, {"/p", "base64"}, [] { decoded("data:;base64,a*b="); });
}

TEST(UriTest, PathsInsideTheFolder) {
    const TestFolder folder;
    const Place place{"f", "/p"};
    folder.write("a b.bin", std::string_view("x"));
    for (const char* uri : {"a b.bin", "a%20b.bin", "./a%20b.bin", "sub/../a b.bin"}) {
        EXPECT_EQ(std::filesystem::weakly_canonical(gltf::resolveUri(uri, folder.path(), place)),
                  std::filesystem::canonical(folder / "a b.bin"))
            << uri;
    }
    // Not there, but inside: a matter for whoever opens it.
    EXPECT_NO_THROW(gltf::resolveUri("missing/file.bin", folder.path(), place));
}

TEST(UriTest, PathsThatLeaveTheFolderAreRefused) {
    const TestFolder folder;
    const Place place{"f", "/p"};
    std::filesystem::create_directory(folder / "scene");
    std::filesystem::create_symlink("/etc", folder.path() / "scene" / "link");
    folder.write("outside.bin", std::string_view("x"));
    for (const char* uri :
         {"../outside.bin", "%2e%2e/outside.bin", "a/../../outside.bin", "link/passwd",
          "/etc/passwd", "%2Fetc/passwd", "..", "\\\\host\\share", "a%00b"}) {
        expectError(ErrorKind::kBadInput, {"f: /p", "relative path"},
                    [&] { gltf::resolveUri(uri, folder / "scene", place); });
    }
    for (const char* uri : {"http://host/a.bin", "https://host/a", "file:///etc/passwd", "C:\\a"}) {
        expectError(ErrorKind::kBadInput, {"f: /p", "relative path"},
                    [&] { gltf::resolveUri(uri, folder / "scene", place); });
    }
}

TEST(UriTest, FolderNamesThatBeginAlikeAreNotInside) {
    const TestFolder folder;
    std::filesystem::create_directory(folder / "scene");
    std::filesystem::create_directory(folder / "scene2");
    expectError(ErrorKind::kBadInput, {"leaves"}, [&] {
        gltf::resolveUri("../scene2/a.bin", folder / "scene", {"f", "/p"});
    });
}

}  // namespace
}  // namespace ribalta::test
