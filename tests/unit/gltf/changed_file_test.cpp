// Files that another program writes to while they are read.
#include <gtest/gtest.h>

#include "base/mapped_file.h"
#include "gltf_file.h"
#include "support/expect_error.h"
#include "support/make_png.h"

namespace ribalta::test {
namespace {

using nlohmann::json;

// A triangle with a picture behind so many bytes that the buffer is mapped.
GltfFile largeFile() {
    GltfFile file = triangleFile();
    file.addView(std::vector<std::byte>(2 * kMappedFrom));
    const std::vector<std::byte> png =
        makePng({.width = 1, .height = 1, .rows = {std::string("\xff\x00\x00\xff", 4)}});
    json& primitive = file.json["meshes"][0]["primitives"][0];
    primitive["attributes"]["TEXCOORD_0"] =
        file.addAccessor(std::vector<float>{0, 0, 1, 0, 0, 1}, "VEC2", kFloat, 3);
    primitive["material"] =
        file.push("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    file.push("textures", {{"source", 0}});
    file.push("images", {{"bufferView", file.addView(png)}, {"mimeType", "image/png"}});
    return file;
}

void expectDecoded(const GltfLoad& load) {
    int pictures = 0;
    const Report report = load.decodeImages([&](std::size_t, const Image& image) {
        pictures += image.width == 1 ? 1 : 0;
        return true;
    });
    EXPECT_EQ(pictures, 1);
    EXPECT_TRUE(report.entries().empty());
}

void expectChanged(const GltfLoad& load) {
    expectError(ErrorKind::kBadInput, {"changed while it was read"},
                [&] { load.decodeImages([](std::size_t, const Image&) { return true; }); });
}

TEST(ChangedFileTest, AGlbThatIsCutBeforeItsPicturesAreRead) {
    const TestFolder folder;
    const std::filesystem::path path = folder.write("large.glb", largeFile().glb());
    const GltfLoad load(path);
    expectDecoded(load);
    std::filesystem::resize_file(path, 10000);
    expectChanged(load);
}

TEST(ChangedFileTest, ABufferThatIsWrittenAnewBeforeItsPicturesAreRead) {
    const TestFolder folder;
    GltfFile file = largeFile();
    file.json["buffers"] = {{{"byteLength", file.bytes().size()}, {"uri", "large.bin"}}};
    const std::filesystem::path buffer = folder.write("large.bin", file.bytes());
    const GltfLoad load(folder.write("large.gltf", file.json.dump()));
    expectDecoded(load);
    // In place, as exporters write.
    folder.write("large.bin", std::vector<std::byte>(file.bytes().size(), std::byte(255)));
    std::filesystem::last_write_time(
        buffer, std::filesystem::last_write_time(buffer) + std::chrono::seconds(1));
    expectChanged(load);
}

}  // namespace
}  // namespace ribalta::test
