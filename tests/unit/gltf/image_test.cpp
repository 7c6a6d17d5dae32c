// Where a texture's picture may come from, and what is drawn where it does not come.
#include <gtest/gtest.h>

#include "gltf_file.h"
#include "support/make_png.h"

namespace ribalta::test {
namespace {

using nlohmann::json;

std::vector<std::byte> redPng() {
    return makePng({.width = 1, .height = 1, .rows = {std::string("\xff\x00\x00\xff", 4)}});
}

// A triangle whose base colour is the given image of the glTF.
GltfFile fileWithImage(const json& image) {
    GltfFile file = triangleFile();
    json& primitive = file.json["meshes"][0]["primitives"][0];
    primitive["attributes"]["TEXCOORD_0"] =
        file.addAccessor(std::vector<float>{0, 0, 1, 0, 0, 1}, "VEC2", 5126, 3);
    primitive["material"] =
        file.push("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    file.push("textures", {{"source", 0}});
    file.push("images", image);
    return file;
}

bool isRed(const LoadedScene& loaded) {
    const Image& image = loaded.scene.images.at(0);
    return image.width == 1 && image.pixels[0] == std::byte(255) && image.pixels[1] == std::byte(0);
}

bool isStandIn(const LoadedScene& loaded) {
    return loaded.scene.images.at(0).pixels == makeStandInImage("").pixels;
}

TEST(GltfImageTest, FromAFileOfAnyName) {
    const TestFolder folder;
    folder.write("a b%c.png", redPng());
    for (const char* uri : {"a b%c.png", "a%20b%c.png", "./a%20b%25c.png"}) {
        const LoadedScene loaded = load(fileWithImage({{"uri", uri}}).writeTo(folder));
        EXPECT_TRUE(isRed(loaded)) << uri << reportText(loaded);
        EXPECT_EQ(reportText(loaded), "");
    }
}

TEST(GltfImageTest, FromADataUriAndFromABufferView) {
    EXPECT_TRUE(isRed(load(fileWithImage({{"uri", "data:image/png;base64," + base64(redPng())}}))));
    EXPECT_TRUE(isRed(load(fileWithImage({{"uri", "DATA:;base64," + base64(redPng())}}))));
    GltfFile file = fileWithImage(json::object());
    file.json["images"][0] = {{"bufferView", file.addView(redPng())}, {"mimeType", "image/png"}};
    EXPECT_TRUE(isRed(load(file)));
    const TestFolder folder;
    EXPECT_TRUE(isRed(load(folder.write("scene.glb", file.glb()))));
}

TEST(GltfImageTest, TheSameFileIsDecodedOnce) {
    const TestFolder folder;
    folder.write("red.png", redPng());
    GltfFile file = fileWithImage({{"uri", "red.png"}});
    file.push("images", {{"uri", "./red.png"}});
    file.push("textures", {{"source", 1}});
    file.json["materials"][0]["emissiveTexture"] = {{"index", 1}};
    const LoadedScene loaded = load(file.writeTo(folder));
    EXPECT_EQ(loaded.scene.textures.size(), 2U);
    EXPECT_EQ(loaded.scene.images.size(), 1U);
}

TEST(GltfImageTest, EqualBytesAreDecodedOnceWhereverTheyLie) {
    const std::vector<std::byte> blue =
        makePng({.width = 1, .height = 1, .rows = {std::string("\x00\x00\xff\xff", 4)}});
    ASSERT_EQ(blue.size(), redPng().size());
    const TestFolder folder;
    folder.write("red.png", redPng());
    folder.write("copy.png", redPng());
    folder.write("blue.png", blue);
    GltfFile file = fileWithImage({{"uri", "red.png"}});
    const json sources[] = {{{"uri", "copy.png"}},
                            {{"bufferView", file.addView(redPng())}, {"mimeType", "image/png"}},
                            {{"bufferView", file.addView(redPng())}, {"mimeType", "image/png"}},
                            {{"uri", "blue.png"}},
                            {{"bufferView", file.addView(blue)}, {"mimeType", "image/png"}}};
    for (const json& source : sources) {
        const int texture = file.push("textures", {{"source", file.push("images", source)}});
        json primitive = file.json["meshes"][0]["primitives"][0];
        primitive["material"] = file.push(
            "materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}});
        file.json["meshes"][0]["primitives"].push_back(primitive);
    }
    const LoadedScene loaded = load(file.writeTo(folder));
    EXPECT_EQ(reportText(loaded), "");
    ASSERT_EQ(loaded.scene.images.size(), 2U);
    EXPECT_TRUE(isRed(loaded));
    EXPECT_EQ(loaded.scene.images[1].pixels[2], std::byte(255));
    const int expected[] = {0, 0, 0, 0, 1, 1};
    ASSERT_EQ(loaded.scene.textures.size(), std::size(expected));
    for (std::size_t i = 0; i < std::size(expected); ++i) {
        EXPECT_EQ(loaded.scene.textures[i].image, expected[i]) << i;
    }
    // What is watched for changes, all the same.
    EXPECT_EQ(loaded.files.size(), 4U);
}

TEST(GltfImageTest, WebPStandsForThePlainSource) {
    const TestFolder folder;
    folder.write("red.png", redPng());
    GltfFile file = fileWithImage({{"uri", "missing.png"}});
    file.push("images", {{"uri", "red.png"}});
    file.json["textures"][0]["extensions"]["EXT_texture_webp"]["source"] = 1;
    EXPECT_TRUE(isRed(load(file.writeTo(folder))));
}

TEST(GltfImageTest, StandInWhereTheFileIsMissingOrBroken) {
    const TestFolder folder;
    folder.write("broken.png", std::string_view("\x89PNG\r\n\x1a\n and then nothing"));
    folder.write("empty.png", std::string_view());
    std::filesystem::create_directory(folder / "folder.png");
    for (const char* uri : {"missing.png", "broken.png", "empty.png", "folder.png"}) {
        const LoadedScene loaded = load(fileWithImage({{"uri", uri}}).writeTo(folder));
        EXPECT_TRUE(isStandIn(loaded)) << uri;
        expectLine(loaded, Report::Kind::kRepaired, "/images/0/uri", uri);
    }
}

TEST(GltfImageTest, StandInWhereTheUriIsRefused) {
    for (const char* uri : {"../red.png", "/etc/passwd", "http://example.org/red.png",
                            "file:///etc/passwd", "a/../../red.png", ""}) {
        const LoadedScene loaded = load(fileWithImage({{"uri", uri}}));
        EXPECT_TRUE(isStandIn(loaded)) << uri;
        expectLine(loaded, Report::Kind::kRepaired, "/images/0/uri", uri);
    }
}

TEST(GltfImageTest, StandInWhereTheBufferViewIsWrong) {
    GltfFile file = fileWithImage(json::object());
    file.json["images"][0] = {{"bufferView", file.addView(redPng())}, {"mimeType", "image/png"}};
    file.json["bufferViews"].back()["byteLength"] = 1 << 20;
    const LoadedScene loaded = load(file);
    EXPECT_TRUE(isStandIn(loaded));
    const std::string view = std::to_string(file.json["bufferViews"].size() - 1);
    expectLine(loaded, Report::Kind::kRepaired, "/bufferViews/" + view, "ends at byte");
    const LoadedScene nothing = load(fileWithImage(json::object()));
    EXPECT_TRUE(isStandIn(nothing));
    expectLine(nothing, Report::Kind::kRepaired, "/images/0", "neither uri nor bufferView");
}

TEST(GltfImageTest, HugePictureIsRefusedBeforeMemoryIsTaken) {
    const LoadedScene loaded = load(fileWithImage(
        {{"uri", "data:image/png;base64," +
                     base64(makePng({.width = 2000000000, .height = 2000000000, .rows = {}}))}}));
    EXPECT_TRUE(isStandIn(loaded));
}

TEST(GltfImageTest, UnusedImagesAreNotTouched) {
    GltfFile file = triangleFile();
    file.push("images", {{"uri", "missing.png"}});
    const LoadedScene loaded = load(file);
    EXPECT_TRUE(loaded.scene.images.empty());
    EXPECT_EQ(reportText(loaded), "");
}

}  // namespace
}  // namespace ribalta::test
