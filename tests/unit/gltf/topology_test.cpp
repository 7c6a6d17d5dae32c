// The seven primitive modes as three topologies.
#include <gtest/gtest.h>

#include "gltf/make_topology.h"
#include "gltf_file.h"

namespace ribalta::test {
namespace {

using Indices = std::vector<std::uint32_t>;

TEST(TopologyTest, ModesUnroll) {
    EXPECT_EQ(gltf::unrollIndices(0, {3, 1, 2}), (Indices{3, 1, 2}));
    EXPECT_EQ(gltf::unrollIndices(1, {0, 1, 2, 3, 4}), (Indices{0, 1, 2, 3}));
    EXPECT_EQ(gltf::unrollIndices(2, {0, 1, 2}), (Indices{0, 1, 1, 2, 2, 0}));
    EXPECT_EQ(gltf::unrollIndices(3, {0, 1, 2}), (Indices{0, 1, 1, 2}));
    EXPECT_EQ(gltf::unrollIndices(4, {0, 1, 2, 3}), (Indices{0, 1, 2}));
    EXPECT_EQ(gltf::unrollIndices(5, {0, 1, 2, 3}), (Indices{0, 1, 2, 1, 3, 2}));
    EXPECT_EQ(gltf::unrollIndices(6, {0, 1, 2, 3}), (Indices{1, 2, 0, 2, 3, 0}));
}

TEST(TopologyTest, CountsAreKnownBeforehand) {
    for (int mode = 0; mode <= 6; ++mode) {
        for (std::size_t count = 0; count < 10; ++count) {
            EXPECT_EQ(gltf::unrollIndices(mode, Indices(count)).size(),
                      gltf::unrolledCount(mode, count))
                << mode << " " << count;
        }
    }
}

TEST(TopologyTest, TooFewVerticesMakeNothing) {
    for (const int mode : {1, 2, 3, 4, 5, 6}) {
        EXPECT_TRUE(gltf::unrollIndices(mode, {}).empty()) << mode;
        EXPECT_TRUE(gltf::unrollIndices(mode, {7}).empty()) << mode;
    }
}

// A strip and a fan of a square keep one winding: all their normals look the same way.
TEST(TopologyTest, StripsAndFansKeepTheWinding) {
    const std::vector<float> zigzag = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    const std::vector<float> around = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    for (const auto& [mode, corners] : {std::pair(5, zigzag), std::pair(6, around)}) {
        GltfFile file;
        file.addMesh({{"mode", mode}, {"attributes", {{"POSITION", file.addPositions(corners)}}}});
        const LoadedScene loaded = load(file);
        const Primitive& primitive = onlyPrimitive(loaded);
        EXPECT_EQ(primitive.topology, Topology::kTriangles);
        EXPECT_EQ(primitive.indices.size(), 6U);
        for (const glm::vec3& normal : primitive.normals) {
            EXPECT_EQ(normal, glm::vec3(0.0F, 0.0F, 1.0F)) << mode;
        }
    }
}

TEST(TopologyTest, PointsAndLinesHaveNoMadeNormals) {
    for (const int mode : {0, 1, 2, 3}) {
        GltfFile file = triangleFile();
        file.json["meshes"][0]["primitives"][0]["mode"] = mode;
        const LoadedScene loaded = load(file);
        EXPECT_TRUE(onlyPrimitive(loaded).normals.empty());
        EXPECT_EQ(onlyPrimitive(loaded).topology, mode == 0 ? Topology::kPoints : Topology::kLines);
    }
}

}  // namespace
}  // namespace ribalta::test
