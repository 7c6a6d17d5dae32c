// Skins and morph targets in files: what is read, what is mended and what is left out.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "gltf/read_deformers.h"
#include "gltf_file.h"

namespace ribalta::test {
namespace {

using nlohmann::json;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

// The triangle (0,0,0) (1,0,0) (0,1,0), node 0, that hangs on two joints, nodes 1 and 2.
struct SkinnedFile : GltfFile {
    SkinnedFile() : GltfFile(triangleFile()) {
        addNode({{"name", "first"}, {"children", {2}}});
        push("nodes", {{"name", "second"}, {"translation", {0, 10, 0}}});
        push("skins", {{"joints", {1, 2}}});
        json["nodes"][0]["skin"] = 0;
        setJoints({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0});
        setWeights({1, 0, 0, 0, 1, 0, 0, 0, 0.5F, 0.5F, 0, 0});
    }

    nlohmann::json& attributes() { return json["meshes"][0]["primitives"][0]["attributes"]; }
    void setJoints(const std::vector<std::uint8_t>& joints, const char* name = "JOINTS_0") {
        attributes()[name] = addAccessor(joints, "VEC4", kUnsignedByte, joints.size() / 4);
    }
    void setWeights(const std::vector<float>& weights, const char* name = "WEIGHTS_0") {
        attributes()[name] = addAccessor(weights, "VEC4", kFloat, weights.size() / 4);
    }
};

// Where the corners of a deformer's first primitive are in the world.
std::vector<glm::dvec3> cornersOf(const Scene& scene, std::size_t index = 0) {
    const Deformer& deformer = scene.deformers.at(index);
    const Node& node = scene.nodes.at(std::size_t(deformer.node));
    const Primitive& primitive = scene.meshes.at(std::size_t(node.mesh)).primitives.at(0);
    std::vector<glm::dvec3> corners;
    for (const glm::vec3& position : deformVertices(primitive, deformer).positions) {
        corners.emplace_back(node.worldFromLocal * glm::dvec4(glm::dvec3(position), 1.0));
    }
    return corners;
}

void expectCorners(const Scene& scene, const std::vector<glm::dvec3>& expected,
                   std::size_t deformer = 0) {
    const std::vector<glm::dvec3> corners = cornersOf(scene, deformer);
    ASSERT_EQ(corners.size(), expected.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        EXPECT_LT(glm::length(corners[i] - expected[i]), 1e-5)
            << i << ": " << corners[i].x << ' ' << corners[i].y << ' ' << corners[i].z;
    }
}

TEST(GltfDeformerTest, JointsMoveTheirVertices) {
    const LoadedScene loaded = load(SkinnedFile());
    EXPECT_EQ(reportText(loaded), "");
    expectCorners(loaded.scene, {{0, 0, 0}, {1, 10, 0}, {0, 6, 0}});
    EXPECT_EQ(onlyPrimitive(loaded).influencesPerVertex, 2);
    EXPECT_FALSE(loaded.scene.nodes.at(0).mesh >= 0);
}

TEST(GltfDeformerTest, TheMeshesOwnNodeDoesNotMoveIt) {
    SkinnedFile file;
    file.json["nodes"][0]["translation"] = {5, 5, 5};
    file.json["nodes"][0]["scale"] = {0, 0, 0};
    file.json["nodes"][0]["name"] = "puppet";
    expectCorners(load(file).scene, {{0, 0, 0}, {1, 10, 0}, {0, 6, 0}});
}

TEST(GltfDeformerTest, BindMatricesAreApplied) {
    SkinnedFile file;
    std::vector<float> matrices(32, 0.0F);
    for (std::size_t i = 0; i < 4; ++i) {
        matrices[5 * i] = matrices[16 + 5 * i] = 1.0F;
    }
    matrices[16 + 13] = -10.0F;  // the second joint's: bound where it stands
    file.json["skins"][0]["inverseBindMatrices"] = file.addAccessor(matrices, "MAT4", kFloat, 2);
    expectCorners(load(file).scene, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});

    matrices[16 + 13] = kNaN;
    file.json["skins"][0]["inverseBindMatrices"] = file.addAccessor(matrices, "MAT4", kFloat, 2);
    const LoadedScene broken = load(file);
    expectLine(broken, Report::Kind::kRepaired, "/skins/0/inverseBindMatrices", "1 matrices");
    expectCorners(broken.scene, {{0, 0, 0}, {1, 10, 0}, {0, 6, 0}});

    matrices.resize(16);
    file.json["skins"][0]["inverseBindMatrices"] = file.addAccessor(matrices, "MAT4", kFloat, 1);
    expectLine(load(file), Report::Kind::kRepaired, "/skins/0/inverseBindMatrices",
               "1 matrices for 2 joints");
    file.json["skins"][0]["inverseBindMatrices"] = 0;
    const LoadedScene unfit = load(file);
    expectLine(unfit, Report::Kind::kRepaired, "/accessors/0", "identity");
    expectCorners(unfit.scene, {{0, 0, 0}, {1, 10, 0}, {0, 6, 0}});
}

TEST(GltfDeformerTest, OneMeshOnSeveralSkins) {
    SkinnedFile file;
    file.addNode({{"translation", {0, 0, 7}}});
    file.push("skins", {{"joints", {3, 1}}});
    file.addNode({{"mesh", 0}, {"skin", 1}});
    file.addNode({{"mesh", 0}, {"translation", {100, 0, 0}}});
    const LoadedScene loaded = load(file);
    EXPECT_EQ(loaded.scene.meshes.size(), 1U);
    ASSERT_EQ(loaded.scene.deformers.size(), 2U);
    expectCorners(loaded.scene, {{0, 0, 0}, {1, 10, 0}, {0, 6, 0}}, 0);
    expectCorners(loaded.scene, {{0, 0, 7}, {1, 0, 0}, {0, 1, 3.5}}, 1);
    EXPECT_EQ(loaded.scene.nodes[5].mesh, 0);  // unskinned, where it stands
    EXPECT_EQ(loaded.scene.nodes[5].deformer, -1);
}

TEST(GltfDeformerTest, JointsOutsideTheSceneAreUsedWhereTheyStand) {
    SkinnedFile file;
    file.json["nodes"][1]["translation"] = {0, 0, 3};
    file.json["scenes"][0]["nodes"] = {0};
    file.json["nodes"][2]["mesh"] = 0;
    const LoadedScene loaded = load(file);
    expectLine(loaded, Report::Kind::kHint, "/skins/0/joints", "not in the scene");
    expectCorners(loaded.scene, {{0, 0, 3}, {1, 10, 3}, {0, 6, 3}});
    int drawn = 0;
    for (const Node& node : loaded.scene.nodes) {
        drawn += node.mesh >= 0 ? 1 : 0;
    }
    EXPECT_EQ(drawn, 1);  // what hangs on such a joint is not
}

TEST(GltfDeformerTest, LampsAndCamerasOfSkinnedNodesStayOne) {
    SkinnedFile file;
    file.json["nodes"][0]["camera"] = file.push(
        "cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}});
    file.json["extensions"]["KHR_lights_punctual"]["lights"] = json::array({{{"type", "point"}}});
    file.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
    file.json["nodes"][0]["translation"] = {1, 2, 3};
    const Scene scene = load(file).scene;
    ASSERT_EQ(scene.cameras.size(), 1U);
    ASSERT_EQ(scene.pointLights.size(), 1U);
    EXPECT_EQ(scene.pointLights[0].position, glm::dvec3(1, 2, 3));
}

TEST(GltfDeformerTest, WeightsAreBroughtToASumOfOne) {
    SkinnedFile file;
    file.setWeights({3, 0, 0, 0, 1, 0, 0, 0, 0.25F, 0.75F * 0.25F / 0.75F, 0, 0});
    const LoadedScene loaded = load(file);
    expectLine(loaded, Report::Kind::kRepaired, "/meshes/0/primitives/0/attributes/WEIGHTS_0",
               "2 vertices");
    expectCorners(loaded.scene, {{0, 0, 0}, {1, 10, 0}, {0, 6, 0}});
}

TEST(GltfDeformerTest, NormalizedBytesAreWeights) {
    SkinnedFile file;
    const std::vector<std::uint8_t> bytes = {255, 0, 0, 0, 255, 0, 0, 0, 127, 128, 0, 0};
    const int accessor = file.addAccessor(bytes, "VEC4", kUnsignedByte, 3);
    file.json["accessors"][std::size_t(accessor)]["normalized"] = true;
    file.attributes()["WEIGHTS_0"] = accessor;
    const LoadedScene loaded = load(file);
    EXPECT_EQ(reportText(loaded), "");
    expectCorners(loaded.scene, {{0, 0, 0}, {1, 10, 0}, {0, 1 + 10 * 128.0 / 255.0, 0}});
}

TEST(GltfDeformerTest, MoreThanFourJoints) {
    SkinnedFile file;
    file.setWeights({0.25F, 0, 0, 0, 0.25F, 0, 0, 0, 0.125F, 0.125F, 0, 0});
    file.setJoints({1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "JOINTS_1");
    file.setWeights({0.75F, 0, 0, 0, 0.75F, 0, 0, 0, 0.75F, 0, 0, 0}, "WEIGHTS_1");
    expectCorners(load(file).scene, {{0, 7.5, 0}, {1, 2.5, 0}, {0, 2.25, 0}});
    file.attributes().erase("WEIGHTS_1");
    expectLine(load(file), Report::Kind::kIgnored, "/meshes/0/primitives/0/attributes/JOINTS_1",
               "WEIGHTS_1");
}

TEST(GltfDeformerTest, BrokenWeightsAndJointsAreMended) {
    const std::string attributes = "/meshes/0/primitives/0/attributes/";
    SkinnedFile file;
    file.setWeights({kNaN, 1, 0, 0, -1, 1, 0, 0, 0, 0, 0, 0});
    const LoadedScene loaded = load(file);
    expectLine(loaded, Report::Kind::kRepaired, attributes + "WEIGHTS_0", "2 weights are negative");
    expectLine(loaded, Report::Kind::kRepaired, attributes + "WEIGHTS_0",
               "1 vertices have no weights");
    expectCorners(loaded.scene, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});

    SkinnedFile far;
    far.setJoints({0, 0, 0, 0, 99, 1, 0, 0, 0, 1, 77, 77});
    far.setWeights({1, 0, 0, 0, 0.5F, 0.5F, 0, 0, 0.5F, 0.5F, 0, 0});
    const LoadedScene mended = load(far);
    expectLine(mended, Report::Kind::kRepaired, attributes + "JOINTS_0", "1 joints are beyond");
    expectCorners(mended.scene, {{0, 0, 0}, {1, 10, 0}, {0, 6, 0}});

    SkinnedFile few;
    few.setWeights({1, 0, 0, 0});
    expectLine(load(few), Report::Kind::kRepaired, attributes + "JOINTS_0", "3 and 1 elements");
}

TEST(GltfDeformerTest, BrokenSkinsCostTheSkin) {
    const auto expectUnskinned = [](const json& skin, const std::string& pointer,
                                    const char* word) {
        SkinnedFile file;
        file.json["skins"][0] = skin;
        const LoadedScene loaded = load(file);
        expectLine(loaded, Report::Kind::kIgnored, pointer, word);
        EXPECT_TRUE(loaded.scene.deformers.empty());
        EXPECT_EQ(loaded.scene.nodes.at(0).mesh, 0);
    };
    expectUnskinned(5, "/skins/0", "no object");
    expectUnskinned(json::object(), "/skins/0", "joints");
    expectUnskinned({{"joints", json::array()}}, "/skins/0/joints", "at least one");
    expectUnskinned({{"joints", {1, 99}}}, "/skins/0/joints/1", "3 nodes");
    SkinnedFile file;
    file.json["skins"] = 7;
    EXPECT_TRUE(load(file).scene.deformers.empty());
    SkinnedFile beyond;
    beyond.json["nodes"][0]["skin"] = 4;
    expectLine(load(beyond), Report::Kind::kRepaired, "/nodes/0/skin", "1 skin");
    SkinnedFile bare;
    bare.attributes().erase("JOINTS_0");
    expectLine(load(bare), Report::Kind::kIgnored, "/nodes/0/skin", "unskinned");
}

TEST(GltfDeformerTest, OddSkinsAreToldThoughUnused) {
    GltfFile file = triangleFile();
    file.addNode({{"name", "apart"}});
    file.push("skins", {{"joints", {0, 1, 1}}, {"skeleton", 1}});
    const LoadedScene loaded = load(file);
    expectLine(loaded, Report::Kind::kHint, "/skins/0/joints", "common root");
    expectLine(loaded, Report::Kind::kHint, "/skins/0/joints", "again");
    expectLine(loaded, Report::Kind::kHint, "/skins/0/skeleton", "above");
    EXPECT_TRUE(loaded.scene.skins.empty());
}

TEST(GltfDeformerTest, JointsOfAllNodesAreCounted) {
    SkinnedFile file;
    const std::size_t joints = 4096;
    file.json["skins"][0]["joints"] = std::vector<int>(joints, 1);
    const std::size_t allowed = gltf::kMaxPosedJoints / joints;
    for (std::size_t i = 1; i < allowed + 2; ++i) {
        file.addNode({{"mesh", 0}, {"skin", 0}});
    }
    const LoadedScene loaded = loadGltf(file.writeTo(TestFolder()));
    EXPECT_EQ(loaded.scene.deformers.size(), allowed);
    expectLine(loaded, Report::Kind::kIgnored, "/nodes/" + std::to_string(allowed + 2), "at rest");
}

// The triangle with a target that lifts its second corner and one that moves all.
struct MorphedFile : GltfFile {
    MorphedFile() : GltfFile(triangleFile()) {
        primitive()["targets"] =
            nlohmann::json::array({{{"POSITION", addPositions({0, 0, 0, 0, 0, 4, 0, 0, 0})}},
                                   {{"POSITION", addPositions({2, 0, 0, 2, 0, 0, 2, 0, 0})}}});
    }
    nlohmann::json& primitive() { return json["meshes"][0]["primitives"][0]; }
    void animate(const std::vector<float>& seconds, const std::vector<float>& weights,
                 const char* interpolation = "LINEAR") {
        const int input = addAccessor(seconds, "SCALAR", kFloat, seconds.size());
        const int output = addAccessor(weights, "SCALAR", kFloat, weights.size());
        json["animations"] = nlohmann::json::array(
            {{{"samplers",
               {{{"input", input}, {"output", output}, {"interpolation", interpolation}}}},
              {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}}}});
    }
};

TEST(GltfDeformerTest, WeightsOfTheNodeGoBeforeTheMeshes) {
    MorphedFile file;
    expectCorners(load(file).scene, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    file.json["meshes"][0]["weights"] = {0.5, 0};
    expectCorners(load(file).scene, {{0, 0, 0}, {1, 0, 2}, {0, 1, 0}});
    file.json["nodes"][0]["weights"] = {0, -1};
    const LoadedScene loaded = load(file);
    EXPECT_EQ(reportText(loaded), "");
    expectCorners(loaded.scene, {{-2, 0, 0}, {-1, 0, 0}, {-2, 1, 0}});
}

TEST(GltfDeformerTest, WeightsOfAnotherNumberAreMended) {
    MorphedFile file;
    file.json["nodes"][0]["weights"] = {0.5};
    const LoadedScene few = load(file);
    expectLine(few, Report::Kind::kRepaired, "/nodes/0/weights", "1 weight for 2");
    expectCorners(few.scene, {{0, 0, 0}, {1, 0, 2}, {0, 1, 0}});
    file.json["nodes"][0]["weights"] = {0.5, 0, 7, 8};
    const LoadedScene many = load(file);
    expectLine(many, Report::Kind::kRepaired, "/nodes/0/weights", "left out");
    expectCorners(many.scene, {{0, 0, 0}, {1, 0, 2}, {0, 1, 0}});
    file.json["nodes"][0]["weights"] = "heavy";
    expectLine(load(file), Report::Kind::kRepaired, "/nodes/0/weights", "array");
    GltfFile plain = triangleFile();
    plain.json["nodes"][0]["weights"] = {1};
    expectLine(load(plain), Report::Kind::kIgnored, "/nodes/0/weights", "no morph targets");
}

TEST(GltfDeformerTest, WeightsArePlayed) {
    MorphedFile file;
    file.animate({0, 2}, {0, 0, 1, 0.5F});
    LoadedScene loaded = load(file);
    EXPECT_EQ(reportText(loaded), "");
    poseScene(loaded.scene, 1.0);
    expectCorners(loaded.scene, {{0.5, 0, 0}, {1.5, 0, 2}, {0.5, 1, 0}});
    restScene(loaded.scene);
    expectCorners(loaded.scene, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});

    file.animate({0, 2}, {0, 0, 0, 0.25F, 0, 0, 0, 0, 0, 0.75F, 0, 0}, "CUBICSPLINE");
    loaded = load(file);
    poseScene(loaded.scene, 2.0);
    expectCorners(loaded.scene, {{1.5, 0, 0}, {2.5, 0, 0}, {1.5, 1, 0}});
}

TEST(GltfDeformerTest, AnimatedWeightsOfAnotherNumberAreMended) {
    MorphedFile file;
    file.animate({0, 2}, {0, 1});
    LoadedScene few = load(file);
    expectLine(few, Report::Kind::kRepaired, "/accessors/4/count", "1 weight for 2");
    poseScene(few.scene, 2.0);
    expectCorners(few.scene, {{0, 0, 0}, {1, 0, 4}, {0, 1, 0}});
    file.animate({0, 2}, {0, 0, 9, 1, 0.5F, 9});
    LoadedScene many = load(file);
    poseScene(many.scene, 2.0);
    expectCorners(many.scene, {{1, 0, 0}, {2, 0, 4}, {1, 1, 0}});
    for (const std::vector<float>& wrong :
         {std::vector<float>{0, 0, 1}, {1}, {0, 0, kNaN, 0}, {0, 0, 1e30F, 0}}) {
        file.animate({0, 2}, wrong);
        EXPECT_TRUE(load(file).scene.animations.at(0).channels.empty());
    }
    GltfFile plain = triangleFile();
    plain.json["animations"] = file.json["animations"];
    plain.json["animations"][0]["samplers"][0] = {{"input", 0}, {"output", 0}};
    expectLine(load(plain), Report::Kind::kIgnored, "/animations/0/channels/0/target/node",
               "without morph targets");
}

TEST(GltfDeformerTest, BrokenTargetsCostThemselves) {
    const std::string targets = "/meshes/0/primitives/0/targets";
    MorphedFile file;
    file.json["nodes"][0]["weights"] = {1, 1};
    file.primitive()["targets"][0]["POSITION"] = file.addPositions({1, 1, 1});
    LoadedScene loaded = load(file);
    expectLine(loaded, Report::Kind::kIgnored, targets + "/0/POSITION", "1 elements");
    expectCorners(loaded.scene, {{2, 0, 0}, {3, 0, 0}, {2, 1, 0}});

    file.primitive()["targets"][0]["POSITION"] = file.addPositions({kNaN, 0, 0, 0, 0, 4, 0, 0, 0});
    loaded = load(file);
    expectLine(loaded, Report::Kind::kRepaired, targets + "/0/POSITION", "0 is used");
    expectCorners(loaded.scene, {{2, 0, 0}, {3, 0, 4}, {2, 1, 0}});

    file.primitive()["targets"][0]["POSITION"] = 99;
    expectLine(load(file), Report::Kind::kRepaired, targets + "/0/POSITION", "accessors");
    file.primitive()["targets"] = "none";
    expectLine(load(file), Report::Kind::kRepaired, targets, "array");
}

TEST(GltfDeformerTest, SparseTargetsWithoutData) {
    MorphedFile file;
    const int indices = file.addView(std::vector<std::uint16_t>{2});
    const int values = file.addView(std::vector<float>{0, 0, 8});
    file.primitive()["targets"][0]["POSITION"] =
        file.push("accessors", {{"componentType", kFloat},
                                {"type", "VEC3"},
                                {"count", 3},
                                {"sparse",
                                 {{"count", 1},
                                  {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                                  {"values", {{"bufferView", values}}}}}});
    file.json["meshes"][0]["weights"] = {0.5, 0};
    expectCorners(load(file).scene, {{0, 0, 0}, {1, 0, 0}, {0, 1, 4}});
}

// Targets without data cost the file nothing, and so there may be any number of them.
TEST(GltfDeformerTest, DisplacementsAreCountedBeforeTheyAreRead) {
    GltfFile file = triangleFile();
    const std::size_t vertices = std::size_t(1) << 20U;
    json empty = {{"componentType", kFloat}, {"type", "VEC3"}, {"count", vertices}};
    json& primitive = file.json["meshes"][0]["primitives"][0];
    primitive["attributes"]["POSITION"] = file.push("accessors", empty);
    const int zeros = file.push("accessors", empty);
    const std::size_t allowed = gltf::kMaxDisplacements / vertices;
    primitive["targets"] = std::vector<json>(allowed + 5, json{{"POSITION", zeros}});
    const LoadedScene loaded = loadGltf(file.writeTo(TestFolder()));
    expectLine(loaded, Report::Kind::kIgnored,
               "/meshes/0/primitives/0/targets/" + std::to_string(allowed) + "/POSITION",
               "5 places");
}

// What load() gives is looked through for numbers that are not finite.
TEST(GltfDeformerTest, HugeNumbersStayFinite) {
    constexpr float kHuge = 1e15F;
    SkinnedFile file;
    std::vector<float> matrices(32, kHuge);
    matrices[3] = matrices[7] = matrices[11] = matrices[19] = matrices[23] = matrices[27] = 0.0F;
    matrices[15] = matrices[31] = 1.0F;
    file.json["nodes"][1]["scale"] = {1e15, 1e15, 1e15};
    file.json["skins"][0]["inverseBindMatrices"] = file.addAccessor(matrices, "MAT4", kFloat, 2);
    file.attributes()["POSITION"] = file.addAccessor(
        std::vector<float>{0, 0, 0, 9e17F, 0, 0, 0, 9e17F, -9e17F}, "VEC3", kFloat, 3);
    const LoadedScene loaded = load(file);
    for (const glm::dvec3& corner : cornersOf(loaded.scene)) {
        EXPECT_LT(glm::length(corner), 1e35);
    }
    file.attributes()["POSITION"] =
        file.addAccessor(std::vector<float>{0, 0, 0, 2e18F, 0, 0, 0, 1, 0}, "VEC3", kFloat, 3);
    expectLine(load(file), Report::Kind::kRepaired, "/meshes/0/primitives/0/attributes/POSITION",
               "below 1e18");
}

TEST(GltfDeformerTest, MorphedNormals) {
    MorphedFile file;
    file.primitive()["attributes"]["NORMAL"] = file.addPositions({0, 0, 1, 0, 0, 1, 0, 0, 1});
    file.primitive()["targets"][0]["NORMAL"] = file.addPositions({1, 0, 0, 0, 0, 0, 0, 0, 0});
    file.json["meshes"][0]["weights"] = {1, 0};
    const Scene scene = load(file).scene;
    const DeformedVertices shape =
        deformVertices(scene.meshes.at(0).primitives.at(0), scene.deformers.at(0));
    const float half = std::sqrt(0.5F);
    EXPECT_LT(glm::length(shape.normals.at(0) - glm::vec3(half, 0, half)), 1e-6F);
    EXPECT_EQ(shape.normals.at(1), glm::vec3(0, 0, 1));
}

}  // namespace
}  // namespace ribalta::test
