// What a file may ask for, and where it may look: at a limit it loads, beyond it is refused before
// memory is taken, whatever makes it large.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "gltf_file.h"
#include "support/expect_error.h"
#include "support/make_png.h"

namespace ribalta::test {
namespace {

using nlohmann::json;

LoadOptions within(std::uint64_t LoadLimits::*limit, std::uint64_t value) {
    LoadOptions options;
    options.limits.*limit = value;
    return options;
}

LoadOptions outsideAllowed() {
    LoadOptions options;
    options.allowOutside = true;
    return options;
}

// Loads at the limit, and is refused at the pointer with one less.
void expectLimit(const GltfFile& file, std::uint64_t LoadLimits::*limit, std::uint64_t value,
                 const std::string& pointer, const std::string& word) {
    const TestFolder folder;
    const std::filesystem::path path = file.writeTo(folder);
    EXPECT_NO_THROW(loadGltf(path, within(limit, value)));
    expectError(ErrorKind::kBadInput, {path.string(), pointer, word, "--limits"},
                [&] { loadGltf(path, within(limit, value - 1)); });
}

// The most memory that this program has had, bytes.
std::uint64_t peakMemory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return std::uint64_t(usage.ru_maxrss) * 1024;
}

// Refused in the end, without having taken more than this on the way.
void expectCheaplyRefused(const GltfFile& file, const std::vector<std::string>& words) {
    constexpr std::uint64_t kAllowed = 200'000'000;
    const TestFolder folder;
    const std::filesystem::path path = file.writeTo(folder);
    const std::uint64_t before = peakMemory();
    expectError(ErrorKind::kBadInput, words, [&] { loadGltf(path); });
    EXPECT_LT(peakMemory(), before + kAllowed);
}

TEST(LimitsTest, Nodes) {
    GltfFile file = triangleFile();
    file.push("nodes", json::object());
    file.push("nodes", json::object());
    expectLimit(file, &LoadLimits::nodes, 3, "/nodes", "nodes");
}

TEST(LimitsTest, Nesting) {
    GltfFile file = triangleFile();
    file.json["extras"] = json::array({json::array({json::array()})});
    const TestFolder folder;
    const std::filesystem::path path = file.writeTo(folder);
    // meshes, mesh, primitives, primitive, attributes, and the document itself.
    EXPECT_NO_THROW(loadGltf(path, within(&LoadLimits::nesting, 6)));
    expectError(ErrorKind::kBadInput, {"line ", "deeper than 5"},
                [&] { loadGltf(path, within(&LoadLimits::nesting, 5)); });
}

TEST(LimitsTest, Vertices) {
    // Three vertices and three indices.
    expectLimit(triangleFile(), &LoadLimits::vertices, 6, "/meshes/0/primitives/0", "vertices");
}

TEST(LimitsTest, VerticesThatStripsAndFlatNormalsMake) {
    GltfFile file;
    std::vector<float> zigzag;
    for (int i = 0; i < 10; ++i) {
        zigzag.insert(zigzag.end(), {float(i / 2), float(i % 2), 0.0F});
    }
    file.addMesh({{"mode", 5}, {"attributes", {{"POSITION", file.addPositions(zigzag)}}}});
    // Eight triangles with vertices of their own.
    expectLimit(file, &LoadLimits::vertices, 48, "/meshes/0/primitives/0", "vertices");
}

TEST(LimitsTest, VerticesOfAllPrimitivesTogether) {
    GltfFile file = triangleFile();
    json& primitives = file.json["meshes"][0]["primitives"];
    const json primitive = primitives[0];
    for (int i = 1; i < 10; ++i) {
        primitives.push_back(primitive);
    }
    expectLimit(file, &LoadLimits::vertices, 60, "/meshes/0/primitives/", "vertices");
}

// A primitive costs some bytes of JSON and has all of an accessor read. Each has other indices:
// what is the same in all is read once.
TEST(LimitsTest, AnAccessorReadOverAndOver) {
    GltfFile file = triangleFile();
    json& primitive = file.json["meshes"][0]["primitives"][0];
    primitive["attributes"]["POSITION"] = file.addPositions(std::vector<float>(3000, 0.5F));
    primitive["indices"] = file.addAccessor(std::vector<std::uint16_t>{0, 1, 2}, "SCALAR", 5123, 3);
    for (int i = 0; i < 40; ++i) {
        json copy = file.json["meshes"][0]["primitives"][0];
        const json indices = file.json["accessors"][copy["indices"].get<std::size_t>()];
        copy["indices"] = file.push("accessors", indices);
        file.json["meshes"][0]["primitives"].push_back(copy);
    }
    const TestFolder folder;
    const std::filesystem::path path = file.writeTo(folder);
    EXPECT_NO_THROW(loadGltf(path, within(&LoadLimits::vertices, 1400)));
    expectError(ErrorKind::kBadInput, {"/accessors/", "again and again"},
                [&] { loadGltf(path, within(&LoadLimits::vertices, 1300)); });
}

TEST(LimitsTest, PixelsOfOnePicture) {
    GltfFile file = triangleFile();
    const std::vector<std::byte> png =
        makePng({.width = 4, .height = 2, .rows = {std::string(16, 'a'), std::string(16, 'b')}});
    file.push("images", {{"bufferView", file.addViewBytes(png.data(), png.size())},
                         {"mimeType", "image/png"}});
    file.push("textures", {{"source", 0}});
    file.push("materials", {{"emissiveTexture", {{"index", 0}}}});
    file.json["meshes"][0]["primitives"][0]["material"] = 0;
    const TestFolder folder;
    const std::filesystem::path path = file.writeTo(folder);
    EXPECT_EQ(reportText(loadGltf(path, within(&LoadLimits::pixels, 8))).find("limit"),
              std::string::npos);
    // One picture less leaves a scene.
    expectLine(loadGltf(path, within(&LoadLimits::pixels, 7)), Report::Kind::kRepaired, "/images/0",
               "4 x 2 pixels");
}

TEST(LimitsTest, MemoryHasToHoldWhatIsLoaded) {
    GltfFile file = triangleFile();
    const TestFolder folder;
    const std::filesystem::path path = file.writeTo(folder);
    EXPECT_NO_THROW(loadGltf(path, within(&LoadLimits::memory, 100'000)));
    for (std::uint64_t bytes = 1; bytes < 4096; bytes = 2 * bytes) {
        expectError(ErrorKind::kBadInput, {path.string(), "limit"},
                    [&] { loadGltf(path, within(&LoadLimits::memory, bytes)); });
    }
}

TEST(LimitsTest, AccessorsThatClaimMuch) {
    for (const char* count : {"4000000000000", "9007199254740991", "4194305"}) {
        GltfFile file = triangleFile();
        file.json["accessors"][0]["count"] = json::parse(count);
        expectCheaplyRefused(file, {"/accessors/0", count});
        file.json["accessors"][0].erase("bufferView");
        expectCheaplyRefused(file, {"/accessors/0", count});
    }
}

TEST(LimitsTest, AccessorsWithoutDataByTheThousand) {
    GltfFile file = triangleFile();
    file.json["accessors"][0] = {{"componentType", 5126}, {"type", "VEC3"}, {"count", 400000}};
    json& primitives = file.json["meshes"][0]["primitives"];
    const json primitive = primitives[0];
    for (int i = 0; i < 10000; ++i) {
        primitives.push_back(primitive);
    }
    const TestFolder folder;
    const std::filesystem::path path = file.writeTo(folder);
    expectError(ErrorKind::kBadInput, {"limit of 800000", "--limits"},
                [&] { loadGltf(path, within(&LoadLimits::vertices, 800'000)); });
}

// Headers alone, of pictures that would take gigabytes: the scene stands without them.
TEST(LimitsTest, PicturesThatClaimMuch) {
    constexpr std::uint64_t kAllowed = 200'000'000;
    const std::string jpeg(
        "\xff\xd8\xff\xc2\0\x11\x08\xff\xff\xff\xff\3\1\x11\0\2\x11\1\3\x11\1"
        "\xff\xda\0\x0c\3\1\0\2\x11\3\x11\0\x3f\0\x12\xff\xd9",
        39);
    const std::string tiff(
        "II*\0\x08\0\0\0\2\0\0\1\4\0\1\0\0\0\0\0\1\0\1\1\4\0\1\0\0\0\0\0\1\0\0\0", 36);
    const std::string exr = std::string("v/1\1\2\0\0\0", 8) +
                            std::string("dataWindow\0box2i\0\x10\0\0\0", 21) +
                            std::string("\0\0\0\0\0\0\0\0\xff\xff\0\0\xff\xff\0\0\0", 17);
    const std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 65535 +X 65535\n\2\2";
    const std::vector<std::byte> png = makePng({.width = 65535, .height = 65535, .rows = {"xxxx"}});
    for (const std::string& picture :
         {jpeg, tiff, exr, hdr,
          std::string(reinterpret_cast<const char*>(png.data()), png.size())}) {
        GltfFile file = triangleFile();
        file.push("images", {{"bufferView", file.addViewBytes(picture.data(), picture.size())}});
        file.push("textures", {{"source", 0}});
        file.push("materials", {{"emissiveTexture", {{"index", 0}}}});
        file.json["meshes"][0]["primitives"][0]["material"] = 0;
        const std::uint64_t before = peakMemory();
        expectLine(load(file), Report::Kind::kRepaired, "/images/0", "over the limit of 32768");
        EXPECT_LT(peakMemory(), before + kAllowed);
    }
}

TEST(LimitsTest, FilesThatAreNotRegularAreNotRead) {
    const TestFolder folder;
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    std::filesystem::create_directory(folder / "below");
    for (const char* uri : {"pipe", "below", "/dev/zero", "/dev/tty"}) {
        GltfFile file = triangleFile();
        json document = file.json;
        document["buffers"] = json::array({{{"uri", uri}, {"byteLength", file.bytes().size()}}});
        const std::filesystem::path path = folder.write("scene.gltf", document.dump());
        expectError(ErrorKind::kBadInput, {"/buffers/0", "not a regular file"},
                    [&] { loadGltf(path, outsideAllowed()); });
    }
}

TEST(LimitsTest, OutsideTheFolderOnlyOnRequest) {
    const TestFolder folder;
    std::filesystem::create_directory(folder / "scene");
    GltfFile file = triangleFile();
    const std::string bytes(reinterpret_cast<const char*>(file.bytes().data()),
                            file.bytes().size());
    const std::filesystem::path outside = folder.write("data.bin", bytes);
    std::filesystem::create_symlink(outside, folder / "scene/link.bin");
    for (const std::string& uri : {std::string("../data.bin"), outside.string(),
                                   std::string("link.bin"), std::string("%2e%2e/data.bin")}) {
        json document = file.json;
        document["buffers"] = json::array({{{"uri", uri}, {"byteLength", bytes.size()}}});
        const std::filesystem::path path = folder.write("scene/scene.gltf", document.dump());
        expectError(ErrorKind::kBadInput, {"/buffers/0/uri", "--allow-outside"},
                    [&] { loadGltf(path); });
        EXPECT_EQ(loadGltf(path, outsideAllowed()).scene.meshes.size(), 1U) << uri;
    }
    json document = file.json;
    document["buffers"] =
        json::array({{{"uri", "file://" + outside.string()}, {"byteLength", bytes.size()}}});
    const std::filesystem::path path = folder.write("scene/scene.gltf", document.dump());
    expectError(ErrorKind::kBadInput, {"/buffers/0/uri", "is not read"},
                [&] { loadGltf(path, outsideAllowed()); });
}

// Only what a buffer says it holds is read of its file.
TEST(LimitsTest, LongFilesBehindShortBuffers) {
    const TestFolder folder;
    GltfFile file = triangleFile();
    const std::string bytes(reinterpret_cast<const char*>(file.bytes().data()),
                            file.bytes().size());
    const std::filesystem::path data = folder.write("data.bin", bytes);
    std::filesystem::resize_file(data, std::uint64_t(1) << 40U);
    json document = file.json;
    document["buffers"] = json::array({{{"uri", "data.bin"}, {"byteLength", bytes.size()}}});
    EXPECT_EQ(loadGltf(folder.write("scene.gltf", document.dump())).scene.meshes.size(), 1U);
}

}  // namespace
}  // namespace ribalta::test
