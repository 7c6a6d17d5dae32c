// Files that are no glTF, containers and buffers that are cut off.
#include <gtest/gtest.h>

#include "gltf_file.h"

namespace ribalta::test {
namespace {

using nlohmann::json;

TEST(BadFileTest, MissingEmptyAndForeignFiles) {
    const TestFolder folder;
    expectRefused(folder / "missing.gltf", "", {"no such file"});
    expectRefused(folder.path(), "", {"not a regular file"});
    expectRefused(folder.write("empty.glb", std::string_view()), "", {"is empty"});
    expectRefused(folder.write("page.glb", std::string_view("<!DOCTYPE html><p>404")), "",
                  {"not a glTF"});
    expectRefused(folder.write("zip.gltf", std::string_view("PK\x03\x04 zip")), "", {"not a glTF"});
    expectRefused(folder.write("wide.gltf", std::string_view("\xff\xfe{\0}\0", 6)), "", {"UTF-16"});
    expectRefused(folder.write("list.gltf", std::string_view("[1, 2]")), "", {"not a glTF"});
}

TEST(BadFileTest, JsonErrorsNameLineAndColumn) {
    const TestFolder folder;
    expectRefused(folder.write("a.gltf", std::string_view("{\n  \"asset\": }")),
                  "line 2, column 12", {"not valid JSON"});
    expectRefused(folder.write("b.gltf", std::string_view("{\"asset\": {\"version\": \"2.0\"")),
                  "line 1, column 27", {"not valid JSON"});
    expectRefused(folder.write("c.gltf", std::string_view("{\"a\": 1e999}")), "",
                  {"not valid JSON", "overflow"});
}

TEST(BadFileTest, ByteOrderMarkIsFine) {
    const TestFolder folder;
    EXPECT_NO_THROW(load(folder.write("bom.gltf", "\xEF\xBB\xBF" + triangleFile().text())));
}

TEST(BadFileTest, DeepNestingIsRefusedNotFollowed) {
    const TestFolder folder;
    std::string deep = "{\"asset\": {\"version\": \"2.0\", \"extras\": ";
    deep += std::string(1000000, '[') + std::string(1000000, ']') + "}}";
    expectRefused(folder.write("deep.gltf", deep), "line 1, column 238", {"nested deeper"});
    // Brackets in strings nest nothing.
    GltfFile file = triangleFile();
    file.json["asset"]["generator"] = std::string(1000, '[') + "\"\\";
    EXPECT_NO_THROW(load(file));
}

TEST(BadFileTest, GlbLoads) {
    const TestFolder folder;
    const LoadedScene loaded = load(folder.write("scene.glb", triangleFile().glb()));
    EXPECT_EQ(onlyPrimitive(loaded).positions.size(), 3U);
    EXPECT_EQ(reportText(loaded), "");
}

TEST(BadFileTest, TruncatedGlbIsRefusedAtAnyLength) {
    const TestFolder folder;
    const std::vector<std::byte> glb = triangleFile().glb();
    for (std::size_t size = 4; size < glb.size(); size += 7) {
        expectRefused(folder.write("cut.glb", std::span(glb).first(size)), "", {"GLB"});
    }
}

TEST(BadFileTest, GlbOfAnotherVersionOrOrderIsRefused) {
    const TestFolder folder;
    std::vector<std::byte> glb = triangleFile().glb();
    glb[4] = std::byte(3);
    expectRefused(folder.write("v3.glb", glb), "", {"version 3"});
    glb[4] = std::byte(2);
    glb[16] = std::byte('X');
    expectRefused(folder.write("order.glb", glb), "", {"first chunk"});
}

TEST(BadFileTest, BuffersShorterThanTheySay) {
    GltfFile file = triangleFile();
    file.json["buffers"] = json::array({{{"byteLength", 48}, {"uri", "data:;base64,AAAA"}}});
    expectRefused(file, "/buffers/0", {"has 3 bytes", "48"});
    const TestFolder folder;
    std::vector<std::byte> glb = triangleFile().glb();
    const TestFolder other;
    file.json["buffers"] = json::array({{{"byteLength", 36}, {"uri", "data.bin"}}});
    expectRefused(file.writeTo(other), "/buffers/0/uri", {"data.bin", "no such file"});
    other.write("data.bin", std::string_view());
    expectRefused(file.writeTo(other), "/buffers/0", {"has 0 bytes"});
    std::filesystem::remove(other / "data.bin");
    std::filesystem::create_directory(other / "data.bin");
    expectRefused(file.writeTo(other), "/buffers/0/uri", {"not a regular file"});
}

TEST(BadFileTest, ExternalBufferMayBeLonger) {
    const TestFolder folder;
    GltfFile file = triangleFile();
    std::vector<std::byte> bytes = file.bytes();
    const std::size_t length = bytes.size();
    bytes.resize(length + 100);
    folder.write("a b.bin", bytes);
    file.json["buffers"] = json::array({{{"byteLength", length}, {"uri", "a%20b.bin"}}});
    EXPECT_EQ(onlyPrimitive(load(file.writeTo(folder))).positions.size(), 3U);
}

TEST(BadFileTest, BufferUrisThatAreNotRead) {
    for (const char* uri :
         {"../data.bin", "/etc/passwd", "http://host/data.bin", "file:///a.bin"}) {
        GltfFile file = triangleFile();
        file.json["buffers"] = json::array({{{"byteLength", 36}, {"uri", uri}}});
        expectRefused(file, "/buffers/0/uri", {uri, "relative path"});
    }
}

TEST(BadFileTest, DracoGarbageIsRefusedOrSkipped) {
    GltfFile file = triangleFile();
    const std::vector<std::uint8_t> garbage = {'D', 'R', 'A', 'C', 'O', 2,  2,   1,   1,   0,   0,
                                               0,   255, 255, 255, 255, 15, 255, 255, 255, 255, 15};
    json draco = file.json["meshes"][0]["primitives"][0];
    draco["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", file.addView(garbage)},
                                                         {"attributes", {{"POSITION", 0}}}};
    file.addMesh(draco);
    const LoadedScene loaded = load(file);
    EXPECT_EQ(loaded.scene.meshes.size(), 2U);
    EXPECT_TRUE(loaded.scene.meshes[1].primitives.empty());
    const std::string pointer = "/meshes/1/primitives/0/extensions/KHR_draco_mesh_compression";
    expectLine(loaded, Report::Kind::kIgnored, pointer, "claims");
    // Nothing is left where the only primitive is garbage.
    file.json["scenes"][0]["nodes"] = {1};
    expectRefused(file, pointer, {"claims"});
    file.json["meshes"][1]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"]
             ["bufferView"] = 99;
    expectRefused(file, pointer, {"bufferView"});
}

}  // namespace
}  // namespace ribalta::test
