// The hierarchy: transforms, scenes, depth, circles.
#include <chrono>
#include <numbers>

#include <gtest/gtest.h>

#include "gltf_file.h"
#include "support/expect_error.h"

namespace ribalta::test {
namespace {

using nlohmann::json;

TEST(GltfNodeTest, TransformsMultiplyDownToTheLeaves) {
    GltfFile file = triangleFile();
    const double half = std::sqrt(0.5);
    file.json["nodes"][0] = {{"name", "root"},
                             {"children", {1}},
                             {"translation", {10, 0, 0}},
                             {"rotation", {0, 0, half, half}},  // a quarter turn about z
                             {"scale", {2, 2, 2}}};
    file.push("nodes", {{"mesh", 0}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 3, 0, 0, 1}}});
    const LoadedScene loaded = load(file);
    ASSERT_EQ(loaded.scene.nodes.size(), 2U);
    EXPECT_EQ(loaded.scene.nodes[0].name, "root");
    EXPECT_EQ(loaded.scene.nodes[1].parent, 0);
    EXPECT_EQ(loaded.scene.nodes[1].mesh, 0);
    const glm::dvec4 origin = loaded.scene.nodes[1].worldFromLocal * glm::dvec4(0, 0, 0, 1);
    EXPECT_NEAR(origin.x, 10.0, 1e-9);
    EXPECT_NEAR(origin.y, 6.0, 1e-9);
    const glm::dvec4 right = loaded.scene.nodes[1].worldFromLocal * glm::dvec4(1, 0, 0, 0);
    EXPECT_NEAR(right.y, 2.0, 1e-9);
}

TEST(GltfNodeTest, OnlyTheDefaultSceneIsLoaded) {
    GltfFile file = triangleFile();
    file.push("nodes", {{"name", "other"}});
    file.json["scenes"].push_back({{"name", "second"}, {"nodes", {1}}});
    file.json["scene"] = 1;
    const LoadedScene second = load(file);
    EXPECT_EQ(second.scene.name, "second");
    ASSERT_EQ(second.scene.nodes.size(), 1U);
    EXPECT_EQ(second.scene.nodes[0].name, "other");
    EXPECT_TRUE(second.scene.meshes.empty());
    expectLine(second, Report::Kind::kIgnored, "/scenes", "2 scenes");
    file.json.erase("scene");
    EXPECT_EQ(load(file).scene.nodes.at(0).mesh, 0);
}

TEST(GltfNodeTest, ASceneIsChosenByNameOrIndex) {
    GltfFile file = triangleFile();
    file.push("nodes", {{"name", "other"}});
    file.json["scenes"][0]["name"] = "first";
    file.json["scenes"].push_back({{"name", "0"}, {"nodes", {1}}});
    const TestFolder folder;
    const std::filesystem::path path = file.writeTo(folder);
    const auto sceneOf = [&](const std::string& text) {
        LoadOptions options;
        options.scene = text;
        return loadGltf(path, options);
    };
    EXPECT_EQ(sceneOf("first").scene.name, "first");
    EXPECT_EQ(sceneOf("1").scene.nodes.at(0).name, "other");
    // A name goes before an index.
    EXPECT_EQ(sceneOf("0").sceneIndex, 1);
    EXPECT_EQ(sceneOf("0").sceneNames, (std::vector<std::string>{"first", "0"}));
    EXPECT_EQ(reportText(sceneOf("first")), "");
    for (const char* wrong : {"third", "2", "-1", " 1", "1x", "", "99999999999999999999999"}) {
        expectError(ErrorKind::kUsage,
                    {path.string(), std::string(wrong).insert(0, "no scene '"), "0 first, 1 0"},
                    [&] { sceneOf(wrong); });
    }
    file.json.erase("scenes");
    file.json.erase("scene");
    file.writeTo(folder);
    expectError(ErrorKind::kUsage, {"none at all"}, [&] { sceneOf("0"); });
    EXPECT_EQ(loadGltf(path).sceneIndex, -1);
}

TEST(GltfNodeTest, WithoutScenesAllRootsAreDrawn) {
    GltfFile file = triangleFile();
    file.push("nodes", {{"children", {2}}});
    file.push("nodes", {{"mesh", 0}});
    file.json.erase("scenes");
    file.json.erase("scene");
    EXPECT_EQ(load(file).scene.nodes.size(), 3U);
}

TEST(GltfNodeTest, HundredThousandNodesInAChain) {
    GltfFile file = triangleFile();
    constexpr int kCount = 100000;
    json nodes = json::array();
    for (int i = 0; i < kCount; ++i) {
        nodes.push_back({{"translation", {0, 0.001, 0}}, {"children", {i + 1}}});
    }
    nodes.push_back({{"mesh", 0}});
    file.json["nodes"] = nodes;
    const LoadedScene loaded = load(file);
    ASSERT_EQ(loaded.scene.nodes.size(), std::size_t(kCount + 1));
    EXPECT_NEAR(loaded.scene.nodes.back().worldFromLocal[3].y, 100.0, 1e-6);
}

TEST(GltfNodeTest, CirclesAreRefused) {
    GltfFile self = triangleFile();
    self.json["nodes"][0]["children"] = {0};
    expectRefused(self, "/nodes/0", {"contains itself"});
    GltfFile ring = triangleFile();
    ring.json["nodes"][0]["children"] = {1};
    ring.push("nodes", {{"children", {2}}});
    ring.push("nodes", {{"children", {0}}});
    expectRefused(ring, "/nodes/0", {"contains itself", "node 1"});
    GltfFile aside = triangleFile();
    aside.push("nodes", {{"children", {2}}});
    aside.push("nodes", {{"children", {1}}});
    expectRefused(aside, "/nodes/1", {"contains itself"});
}

TEST(GltfNodeTest, SecondParentIsTakenOff) {
    GltfFile file = triangleFile();
    file.json["nodes"][0]["children"] = {2};
    file.addNode({{"children", {2}}});
    file.push("nodes", {{"name", "child"}});
    const LoadedScene loaded = load(file);
    EXPECT_EQ(loaded.scene.nodes.size(), 3U);
    expectLine(loaded, Report::Kind::kRepaired, "/nodes/1/children/0", "already hangs on node 0");
}

TEST(GltfNodeTest, RootThatIsAChildIsDrawnOnce) {
    GltfFile file = triangleFile();
    file.json["nodes"][0]["children"] = {1};
    file.addNode({{"name", "child"}});
    const LoadedScene loaded = load(file);
    EXPECT_EQ(loaded.scene.nodes.size(), 2U);
    expectLine(loaded, Report::Kind::kRepaired, "/scenes/0/nodes/1", "its root, node 0");
    // In the other order, and alone, it still stands where its parent puts it.
    for (const json& roots : {json{1, 0}, json{1}}) {
        file.json["scenes"][0]["nodes"] = roots;
        file.json["nodes"][0]["translation"] = {3, 0, 0};
        const LoadedScene turned = load(file);
        ASSERT_EQ(turned.scene.nodes.size(), 2U);
        EXPECT_EQ(turned.scene.nodes[1].name, "child");
        EXPECT_EQ(turned.scene.nodes[1].worldFromLocal[3].x, 3.0);
    }
}

TEST(GltfNodeTest, ImpossibleTransformsAreMended) {
    GltfFile file = triangleFile();
    file.json["nodes"][0]["rotation"] = {0, 0, 0, 0};
    expectLine(load(file), Report::Kind::kRepaired, "/nodes/0/rotation", "no rotation");

    file.json["nodes"][0]["rotation"] = {0, 0, 0, 2};
    const LoadedScene longer = load(file);
    expectLine(longer, Report::Kind::kRepaired, "/nodes/0/rotation", "expected 1");
    EXPECT_EQ(longer.scene.nodes[0].worldFromLocal, glm::dmat4(1.0));

    file.json["nodes"][0] = {{"mesh", 0}, {"scale", {1e300, 1, 1}}};
    expectLine(load(file), Report::Kind::kRepaired, "/nodes/0", "out of all bounds");

    file.json["nodes"][0] = {{"mesh", 0}, {"scale", {0, 0, 0}}};
    const LoadedScene hidden = load(file);
    EXPECT_TRUE(hidden.scene.meshes.empty());
    expectLine(hidden, Report::Kind::kIgnored, "/nodes/0", "scaled to nothing");

    file.json["nodes"][0] = {{"mesh", 0},
                             {"matrix", {1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 2}}};
    expectLine(load(file), Report::Kind::kRepaired, "/nodes/0/matrix", "last row");
}

TEST(GltfNodeTest, ScalesThatMultiplyToInfinityAreMended) {
    GltfFile file = triangleFile();
    json nodes = json::array();
    for (int i = 0; i < 20; ++i) {
        nodes.push_back({{"scale", {1e20, 1e20, 1e20}}, {"children", {i + 1}}});
    }
    nodes.push_back({{"mesh", 0}});
    file.json["nodes"] = nodes;
    expectLine(load(file), Report::Kind::kRepaired, "/nodes/1", "with its parents'");
}

TEST(GltfNodeTest, MeshOnSeveralNodesIsDecodedOnce) {
    GltfFile file = triangleFile();
    file.push("meshes", file.json["meshes"][0]);
    file.addNode({{"mesh", 0}});
    const LoadedScene loaded = load(file);
    EXPECT_EQ(loaded.scene.meshes.size(), 1U);
    EXPECT_EQ(loaded.scene.nodes[1].mesh, 0);
}

}  // namespace
}  // namespace ribalta::test
