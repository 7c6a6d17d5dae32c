// Normals and tangents that files leave out.
#include <gtest/gtest.h>

#include "gltf/make_normals.h"
#include "gltf/make_tangents.h"
#include "gltf_file.h"

namespace ribalta::test {
namespace {

// Two triangles of a roof that share an edge.
GltfFile roofFile() {
    GltfFile file;
    const int positions = file.addPositions({-1, 0, 0, 0, 1, -1, 0, 1, 1, 1, 0, 0});
    const int uvs = file.addAccessor(std::vector<float>{0, 0, 1, 0, 0, 1, 1, 1}, "VEC2", 5126, 4);
    file.addMesh({{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", uvs}}},
                  {"indices", file.addAccessor(std::vector<std::uint16_t>{0, 2, 1, 3, 1, 2},
                                               "SCALAR", 5123, 6)}});
    return file;
}

TEST(MakeNormalsTest, AreFlatAndUnshareVertices) {
    const LoadedScene loaded = load(roofFile());
    const Primitive& primitive = onlyPrimitive(loaded);
    ASSERT_EQ(primitive.positions.size(), 6U);
    ASSERT_EQ(primitive.uv0.size(), 6U);
    EXPECT_EQ(primitive.uv0[1], glm::vec2(0.0F, 1.0F));
    const float half = std::sqrt(0.5F);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_NEAR(primitive.normals[i].x, i < 3 ? -half : half, 1e-6F);
        EXPECT_NEAR(primitive.normals[i].y, half, 1e-6F);
    }
}

TEST(MakeNormalsTest, TriangleWithoutAreaHasANormal) {
    Primitive primitive;
    primitive.positions.assign(3, glm::vec3(1.0F));
    primitive.indices = {0, 1, 2};
    gltf::makeFlatNormals(primitive);
    EXPECT_EQ(primitive.normals[2], glm::vec3(0.0F, 1.0F, 0.0F));
}

// A square in the xy plane, seen from +z, its texture turned and mirrored in different ways.
TEST(MakeTangentsTest, FollowTheTexture) {
    Primitive square;
    square.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    square.normals.assign(4, glm::vec3(0.0F, 0.0F, 1.0F));
    square.indices = {0, 1, 2, 0, 2, 3};
    struct Case {
        std::vector<glm::vec2> uv;
        glm::vec4 tangent;
    };
    const Case cases[] = {
        // u to the right, v downwards, as glTF's pictures lie: mirrored against a right-handed
        // frame.
        {{{0, 1}, {1, 1}, {1, 0}, {0, 0}}, {1.0F, 0.0F, 0.0F, -1.0F}},
        {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {1.0F, 0.0F, 0.0F, 1.0F}},
        {{{0, 0}, {0, 1}, {1, 1}, {1, 0}}, {0.0F, 1.0F, 0.0F, -1.0F}},
        {{{1, 0}, {0, 0}, {0, 1}, {1, 1}}, {-1.0F, 0.0F, 0.0F, -1.0F}},
    };
    for (const Case& c : cases) {
        gltf::makeTangents(square, c.uv);
        for (const glm::vec4& tangent : square.tangents) {
            for (int k = 0; k < 4; ++k) {
                EXPECT_NEAR(tangent[k], c.tangent[k], 1e-6F);
            }
        }
    }
}

TEST(MakeTangentsTest, WithoutTextureDirectionAnyAcrossTheNormal) {
    Primitive triangle;
    triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    triangle.normals.assign(3, glm::vec3(1.0F, 0.0F, 0.0F));
    triangle.indices = {0, 1, 2};
    gltf::makeTangents(triangle, std::vector<glm::vec2>(3, glm::vec2(0.5F)));
    for (const glm::vec4& tangent : triangle.tangents) {
        EXPECT_NEAR(glm::length(glm::vec3(tangent.x, tangent.y, tangent.z)), 1.0F, 1e-6F);
        EXPECT_NEAR(tangent.x, 0.0F, 1e-6F);
    }
}

TEST(MakeTangentsTest, OnlyWhereANormalMapNeedsThem) {
    GltfFile file = roofFile();
    EXPECT_TRUE(onlyPrimitive(load(file)).tangents.empty());
    file.push("textures", nlohmann::json::object());
    file.push("materials", {{"normalTexture", {{"index", 0}}}});
    file.json["meshes"][0]["primitives"][0]["material"] = 0;
    EXPECT_EQ(onlyPrimitive(load(file)).tangents.size(), 6U);
}

}  // namespace
}  // namespace ribalta::test
