// Accessors of every kind as vertex attributes and indices.
#include <limits>

#include <gtest/gtest.h>

#include "gltf_file.h"

namespace ribalta::test {
namespace {

using nlohmann::json;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// A triangle whose attribute `name` is given by an accessor of three elements.
template <typename T>
LoadedScene loadWith(const std::string& name, const std::vector<T>& numbers,
                     const std::string& type, int componentType, bool normalized) {
    GltfFile file = triangleFile();
    const int accessor = file.addAccessor(numbers, type, componentType, 3);
    file.json["accessors"][std::size_t(accessor)]["normalized"] = normalized;
    file.json["meshes"][0]["primitives"][0]["attributes"][name] = accessor;
    return load(file);
}

TEST(AttributesTest, TexcoordsOfEveryType) {
    using Pairs = std::vector<glm::vec2>;
    const Pairs expected = {{0.0F, 1.0F}, {1.0F, 0.0F}, {0.0F, 0.0F}};
    EXPECT_EQ(onlyPrimitive(
                  loadWith("TEXCOORD_0", std::vector<float>{0, 1, 1, 0, 0, 0}, "VEC2", 5126, false))
                  .uv0,
              expected);
    const std::vector<std::uint16_t> shorts = {0, 65535, 65535, 0, 0, 0};
    EXPECT_EQ(onlyPrimitive(loadWith("TEXCOORD_1", shorts, "VEC2", 5123, true)).uv1, expected);
}

TEST(AttributesTest, SignedNormalisedIntegersReachMinusOne) {
    const LoadedScene loaded =
        loadWith("NORMAL", std::vector<std::int16_t>{-32768, 0, 0, 0, 32767, 0, 0, 0, -32767},
                 "VEC3", 5122, true);
    const Primitive& primitive = onlyPrimitive(loaded);
    EXPECT_EQ(primitive.normals[0], glm::vec3(-1.0F, 0.0F, 0.0F));
    EXPECT_EQ(primitive.normals[1], glm::vec3(0.0F, 1.0F, 0.0F));
    EXPECT_EQ(primitive.normals[2], glm::vec3(0.0F, 0.0F, -1.0F));
    expectLine(loaded, Report::Kind::kHint, "/meshes/0/primitives/0/attributes/NORMAL",
               "KHR_mesh_quantization");
}

TEST(AttributesTest, QuantizedPositionsAreWholeMetres) {
    GltfFile file;
    const std::vector<std::int8_t> bytes = {0, 0, 0, 0, 5, 0, 0, 0, 0, -7, 0, 0};
    const int view = file.addView(bytes);
    file.json["bufferViews"][std::size_t(view)]["byteStride"] = 4;
    const int positions =
        file.push("accessors",
                  {{"bufferView", view}, {"componentType", 5120}, {"type", "VEC3"}, {"count", 3}});
    file.addMesh({{"attributes", {{"POSITION", positions}}}});
    file.json["extensionsUsed"] = file.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    const LoadedScene loaded = load(file);
    EXPECT_EQ(onlyPrimitive(loaded).positions[1], glm::vec3(5.0F, 0.0F, 0.0F));
    EXPECT_EQ(onlyPrimitive(loaded).positions[2], glm::vec3(0.0F, -7.0F, 0.0F));
    EXPECT_EQ(reportText(loaded), "");
}

TEST(AttributesTest, ColoursOfThreeAndFourComponents) {
    const LoadedScene rgb = loadWith("COLOR_0", std::vector<float>{1, 0, 0, 0, 0.5, 0, 0, 0, 0.25},
                                     "VEC3", 5126, false);
    EXPECT_EQ(onlyPrimitive(rgb).colors[1], glm::vec4(0.0F, 0.5F, 0.0F, 1.0F));
    const std::vector<std::uint8_t> bytes = {255, 0, 0, 0, 0, 51, 0, 255, 0, 0, 102, 255};
    const LoadedScene rgba = loadWith("COLOR_0", bytes, "VEC4", 5121, true);
    EXPECT_EQ(onlyPrimitive(rgba).colors[0], glm::vec4(1.0F, 0.0F, 0.0F, 0.0F));
    EXPECT_FLOAT_EQ(onlyPrimitive(rgba).colors[1].y, 0.2F);
    const std::vector<std::uint16_t> shorts = {65535, 0, 0, 0, 13107, 0, 0, 0, 0};
    const LoadedScene rgb16 =
        loadWith("COLOR_0", std::vector<std::uint16_t>(shorts), "VEC3", 5123, true);
    EXPECT_FLOAT_EQ(onlyPrimitive(rgb16).colors[1].y, 0.2F);
}

TEST(AttributesTest, InterleavedWithOffsets) {
    GltfFile file;
    // Position and texture coordinates, 20 bytes a vertex, behind 4 bytes of something else.
    const std::vector<float> numbers = {99, 0,    0,    0, 0.1F, 0.2F, 1,    0,
                                        0,  0.3F, 0.4F, 0, 1,    0,    0.5F, 0.6F};
    const int view = file.addView(numbers);
    file.json["bufferViews"][std::size_t(view)]["byteStride"] = 20;
    const json common = {{"bufferView", view}, {"componentType", 5126}, {"count", 3}};
    json position = common;
    position.update({{"type", "VEC3"}, {"byteOffset", 4}});
    json uv = common;
    uv.update({{"type", "VEC2"}, {"byteOffset", 16}});
    file.push("accessors", position);
    file.push("accessors", uv);
    file.addMesh({{"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}}}});
    const LoadedScene loaded = load(file);
    EXPECT_EQ(onlyPrimitive(loaded).positions[2], glm::vec3(0.0F, 1.0F, 0.0F));
    EXPECT_EQ(onlyPrimitive(loaded).uv0[1], glm::vec2(0.3F, 0.4F));
}

TEST(AttributesTest, SparseReplacesElements) {
    GltfFile file = triangleFile();
    file.json["accessors"][0]["sparse"] = {
        {"count", 2},
        {"indices",
         {{"bufferView", file.addView(std::vector<std::uint8_t>{0, 2})}, {"componentType", 5121}}},
        {"values", {{"bufferView", file.addView(std::vector<float>{5, 5, 5, 7, 7, 7})}}}};
    const LoadedScene loaded = load(file);
    const Primitive& primitive = onlyPrimitive(loaded);
    EXPECT_EQ(primitive.positions[0], glm::vec3(5.0F));
    EXPECT_EQ(primitive.positions[1], glm::vec3(1.0F, 0.0F, 0.0F));
    EXPECT_EQ(primitive.positions[2], glm::vec3(7.0F));
}

TEST(AttributesTest, SparseWithoutBufferViewStartsFromZero) {
    GltfFile file;
    const int accessor = file.push(
        "accessors",
        {{"componentType", 5126},
         {"type", "VEC3"},
         {"count", 3},
         {"sparse",
          {{"count", 2},
           {"indices",
            {{"bufferView", file.addView(std::vector<std::uint16_t>{1, 2})},
             {"componentType", 5123}}},
           {"values", {{"bufferView", file.addView(std::vector<float>{1, 0, 0, 0, 1, 0})}}}}}});
    file.addMesh({{"attributes", {{"POSITION", accessor}}}});
    const LoadedScene loaded = load(file);
    EXPECT_EQ(onlyPrimitive(loaded).positions[0], glm::vec3(0.0F));
    EXPECT_EQ(onlyPrimitive(loaded).positions[1], glm::vec3(1.0F, 0.0F, 0.0F));
}

TEST(AttributesTest, IndicesOfEveryType) {
    const auto indicesOf = [](auto numbers, int componentType) {
        GltfFile file = triangleFile();
        file.json["meshes"][0]["primitives"][0]["indices"] =
            file.addAccessor(numbers, "SCALAR", componentType, 3);
        file.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
            file.addPositions({0, 0, 1, 0, 0, 1, 0, 0, 1});
        return onlyPrimitive(load(file)).indices;
    };
    const std::vector<std::uint32_t> expected = {0, 2, 1};
    EXPECT_EQ(indicesOf(std::vector<std::uint8_t>{0, 2, 1}, 5121), expected);
    EXPECT_EQ(indicesOf(std::vector<std::uint16_t>{0, 2, 1}, 5123), expected);
    EXPECT_EQ(indicesOf(std::vector<std::uint32_t>{0, 2, 1}, 5125), expected);
}

TEST(AttributesTest, IndicesWithoutBufferViewAreZero) {
    GltfFile file = triangleFile();
    file.json["meshes"][0]["primitives"][0]["indices"] =
        file.push("accessors", {{"componentType", 5123}, {"type", "SCALAR"}, {"count", 3}});
    file.json["meshes"][0]["primitives"][0]["mode"] = 0;
    EXPECT_EQ(onlyPrimitive(load(file)).indices, (std::vector<std::uint32_t>{0, 0, 0}));
}

TEST(AttributesTest, VerticesThatNothingDrawsAreLeftOut) {
    GltfFile file;
    const int positions = file.addPositions({9, 9, 9, 0, 0, 0, 1, 0, 0, 0, 1, 0, 9, 9, 9});
    const int normals = file.addPositions({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    file.addMesh(
        {{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}},
         {"indices", file.addAccessor(std::vector<std::uint16_t>{3, 1, 2}, "SCALAR", 5123, 3)}});
    const LoadedScene loaded = load(file);
    const Primitive& primitive = onlyPrimitive(loaded);
    EXPECT_EQ(primitive.positions.size(), 3U);
    EXPECT_EQ(primitive.indices, (std::vector<std::uint32_t>{2, 0, 1}));
    EXPECT_EQ(primitive.bounds.high, glm::dvec3(1.0, 1.0, 0.0));
}

TEST(AttributesTest, TrianglesWithoutFinitePlaceAreLeftOut) {
    GltfFile file;
    file.addMesh({{"attributes",
                   {{"POSITION", file.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0,  //
                                                    0, 0, 0, kNan, 0, 0, 0, 1, 0})}}}});
    const LoadedScene loaded = load(file);
    EXPECT_EQ(onlyPrimitive(loaded).indices.size(), 3U);
    expectLine(loaded, Report::Kind::kRepaired, "/meshes/0/primitives/0/attributes/POSITION",
               "1 of 2");
}

TEST(AttributesTest, OtherNumbersThatAreNoneAreReplaced) {
    const LoadedScene loaded =
        loadWith("TEXCOORD_0", std::vector<float>{kNan, 0, 0, 1, 0, 0}, "VEC2", 5126, false);
    EXPECT_EQ(onlyPrimitive(loaded).uv0[0], glm::vec2(0.0F));
    expectLine(loaded, Report::Kind::kRepaired, "/meshes/0/primitives/0/attributes/TEXCOORD_0",
               "not finite");
    const LoadedScene normals =
        loadWith("NORMAL", std::vector<float>{0, 0, 0, 0, 0, 1, 0, 0, kNan}, "VEC3", 5126, false);
    EXPECT_EQ(onlyPrimitive(normals).normals[0], glm::vec3(0.0F, 1.0F, 0.0F));
    expectLine(normals, Report::Kind::kRepaired, "/meshes/0/primitives/0/attributes/NORMAL",
               "2 normals");
}

TEST(AttributesTest, AttributeOfAnotherLengthIsLeftOut) {
    GltfFile file = triangleFile();
    file.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] =
        file.addAccessor(std::vector<float>{0, 0, 1, 1}, "VEC2", 5126, 2);
    const LoadedScene loaded = load(file);
    EXPECT_TRUE(onlyPrimitive(loaded).uv0.empty());
    expectLine(loaded, Report::Kind::kRepaired, "/meshes/0/primitives/0/attributes/TEXCOORD_0",
               "2 elements for 3 vertices");
}

TEST(AttributesTest, RestartValueIsAVertexAndSaidSo) {
    GltfFile file;
    const int positions = file.addPositions(std::vector<float>(256 * 3, 1.0F));
    file.addMesh(
        {{"mode", 0},
         {"attributes", {{"POSITION", positions}}},
         {"indices", file.addAccessor(std::vector<std::uint8_t>{0, 255}, "SCALAR", 5121, 2)}});
    expectLine(load(file), Report::Kind::kRepaired, "/meshes/0/primitives/0/indices", "restart");
}

}  // namespace
}  // namespace ribalta::test
