// Which draws are one call, and in what order they then stand.
#include "render/draw_list.h"

#include <gtest/gtest.h>

#include "support/stage.h"

namespace ribalta::test {
namespace {

// Two meshes, a and b, on nodes in turn: a b a a(mirrored) b a; then a deformed a.
Scene mixedScene() {
    Scene scene;
    addShape(scene, makeBox({0, 0, 0}, {1, 1, 1}), makeMaterial(glm::vec3(0.5F)));
    addShape(scene, makeBox({0, 0, 0}, {2, 1, 1}), makeMaterial(glm::vec3(0.5F)));
    for (const int mesh : {0, 0, 1, 0, 0}) {
        Node node;
        node.mesh = mesh;
        scene.nodes.push_back(node);
    }
    scene.nodes[3].parentFromLocal[0][0] = -1.0;
    Deformer deformer;
    deformer.node = 6;
    scene.nodes[6].deformer = 0;
    scene.deformers.push_back(deformer);
    placeNodes(scene);
    return scene;
}

std::vector<std::size_t> runsOf(const Scene& scene, const std::vector<DrawItem>& draws,
                                const std::vector<int>& list) {
    std::vector<std::size_t> lengths;
    for (std::size_t first = 0, end = 0; first < list.size(); first = end) {
        end = endOfInstances(scene, draws, list, first);
        lengths.push_back(end - first);
    }
    return lengths;
}

TEST(DrawList, InstancesStandTogetherAtTheirFirst) {
    const Scene scene = mixedScene();
    const std::vector<DrawItem> draws = listDraws(scene);
    ASSERT_EQ(draws.size(), 7U);
    EXPECT_TRUE(draws[3].mirrored);
    std::vector<int> list = {5, 4, 3, 6, 2, 1, 0};
    gatherInstances(scene, draws, list);
    EXPECT_EQ(list, (std::vector<int>{5, 2, 0, 4, 1, 3, 6}));
    EXPECT_EQ(runsOf(scene, draws, list), (std::vector<std::size_t>{3, 2, 1, 1}));
}

TEST(DrawList, WhatIsMirroredOrDeformedIsNoInstance) {
    const Scene scene = mixedScene();
    const std::vector<DrawItem> draws = listDraws(scene);
    EXPECT_TRUE(areInstances(scene, draws[0], draws[2]));
    EXPECT_FALSE(areInstances(scene, draws[0], draws[1]));
    EXPECT_FALSE(areInstances(scene, draws[0], draws[3]));
    EXPECT_FALSE(areInstances(scene, draws[0], draws[6]));
}

TEST(DrawList, RunsOfAListThatIsNotGathered) {
    const Scene scene = mixedScene();
    const std::vector<DrawItem> draws = listDraws(scene);
    EXPECT_EQ(runsOf(scene, draws, {0, 2, 1, 4, 5}), (std::vector<std::size_t>{2, 2, 1}));
    EXPECT_TRUE(runsOf(scene, draws, {}).empty());
}

}  // namespace
}  // namespace ribalta::test
