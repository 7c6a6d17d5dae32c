// Equal geometry is decoded once and numbered for one upload, however the file comes by it.
#include <gtest/gtest.h>

#include "gltf_file.h"

namespace ribalta::test {
namespace {

using nlohmann::json;

const Primitive& primitiveOf(const LoadedScene& loaded, std::size_t mesh) {
    return loaded.scene.meshes.at(mesh).primitives.at(0);
}

TEST(ShareGeometryTest, EqualVerticesAndEqualIndicesEachHaveTheirNumber) {
    const std::vector<float> square = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    std::vector<float> other = square;
    other.back() = 0.5F;
    GltfFile file;
    const int positions = file.addPositions(square);
    const int copy = file.addPositions(square);
    const int others = file.addPositions(other);
    const auto indices = [&](const std::vector<std::uint32_t>& list) {
        return file.addAccessor(list, "SCALAR", 5125, list.size());
    };
    const int first = indices({0, 1, 2});
    const int both = indices({0, 1, 2, 2, 1, 3});
    const int material = file.push("materials", {{"name", "red"}});
    const auto add = [&](int position, int index) {
        file.addNode({{"mesh", file.push("meshes", {{"primitives",
                                                     {{{"attributes", {{"POSITION", position}}},
                                                       {"indices", index},
                                                       {"material", material}}}}})}});
    };
    // Normals are made, so that triangles have vertices of their own and equal counts for equal.
    add(positions, both);
    add(positions, both);
    add(copy, both);
    add(others, both);
    add(positions, first);
    const LoadedScene loaded = load(file);
    EXPECT_EQ(reportText(loaded), "");
    ASSERT_EQ(loaded.scene.meshes.size(), 5U);
    const int shared = primitiveOf(loaded, 0).sharedVertices;
    EXPECT_GE(shared, 0);
    EXPECT_EQ(primitiveOf(loaded, 1).sharedVertices, shared);
    EXPECT_EQ(primitiveOf(loaded, 2).sharedVertices, shared);
    EXPECT_EQ(primitiveOf(loaded, 3).sharedVertices, -1);
    EXPECT_EQ(primitiveOf(loaded, 4).sharedVertices, -1);
    // Unrolled they count from 0 in all of the same length.
    const int list = primitiveOf(loaded, 0).sharedIndices;
    EXPECT_GE(list, 0);
    EXPECT_EQ(primitiveOf(loaded, 3).sharedIndices, list);
    EXPECT_EQ(primitiveOf(loaded, 4).sharedIndices, -1);
}

TEST(ShareGeometryTest, TheSameDataUnderAnotherMaterialKeepsItsMaterial) {
    GltfFile file = triangleFile();
    const json primitive = file.json["meshes"][0]["primitives"][0];
    for (const char* name : {"red", "blue"}) {
        json another = primitive;
        another["material"] = file.push("materials", {{"name", name}});
        file.json["meshes"][0]["primitives"].push_back(another);
    }
    const LoadedScene loaded = load(file);
    const std::vector<Primitive>& primitives = loaded.scene.meshes.at(0).primitives;
    ASSERT_EQ(primitives.size(), 3U);
    const char* const expected[] = {nullptr, "red", "blue"};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(primitives[i].positions, primitives[0].positions);
        EXPECT_EQ(primitives[i].sharedVertices, 0);
        EXPECT_EQ(primitives[i].sharedIndices, 0);
        if (expected[i] == nullptr) {
            EXPECT_EQ(primitives[i].material, -1);
        } else {
            EXPECT_EQ(loaded.scene.materials.at(std::size_t(primitives[i].material)).name,
                      expected[i]);
        }
    }
}

// A fault is told for each place that has it.
TEST(ShareGeometryTest, WhatIsReportedIsReportedForEach) {
    GltfFile file = triangleFile();
    json& primitive = file.json["meshes"][0]["primitives"][0];
    primitive["indices"] = file.addAccessor(std::vector<std::uint32_t>{0, 1, 7}, "SCALAR", 5125, 3);
    const json broken = primitive;
    file.json["meshes"][0]["primitives"].push_back(broken);
    json whole = broken;
    whole.erase("indices");
    file.json["meshes"][0]["primitives"].push_back(whole);
    const LoadedScene loaded = load(file);
    for (const char* place : {"0", "1"}) {
        expectLine(loaded, Report::Kind::kIgnored,
                   std::string("/meshes/0/primitives/") + place + "/indices", "only 3 vertices");
    }
    EXPECT_EQ(loaded.scene.meshes.at(0).primitives.size(), 1U);
}

}  // namespace
}  // namespace ribalta::test
