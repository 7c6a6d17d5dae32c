// Nodes, cameras and lamps in the world, and the box around what is drawn.

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "scene/scene.h"

namespace ribalta {
namespace {

Node node(int parent, const glm::dmat4& parentFromLocal) {
    Node result;
    result.parent = parent;
    result.parentFromLocal = parentFromLocal;
    return result;
}

glm::dmat4 moved(double x, double y, double z) {
    return glm::translate(glm::dmat4(1.0), {x, y, z});
}

/// A moved rig, and on it an arm turned to shine straight down.
Scene rig() {
    Scene scene;
    scene.nodes.push_back(node(-1, moved(0.0, 6.0, 0.0)));
    scene.nodes.push_back(
        node(0, glm::rotate(moved(2.0, 0.0, 0.0), glm::radians(-90.0), {1.0, 0.0, 0.0})));
    return scene;
}

TEST(PlaceNodes, LampsAndCamerasFollowTheirNodes) {
    Scene scene = rig();
    scene.spotLights.emplace_back().node = 1;
    scene.pointLights.emplace_back().node = 1;
    scene.directionalLights.emplace_back().node = 1;
    scene.cameras.emplace_back().node = 1;
    placeNodes(scene);
    const glm::dvec3 place(2.0, 6.0, 0.0);
    const glm::dvec3 down(0.0, -1.0, 0.0);
    EXPECT_NEAR(glm::distance(scene.spotLights[0].frame.position, place), 0.0, 1e-12);
    EXPECT_NEAR(glm::distance(scene.spotLights[0].frame.forward(), down), 0.0, 1e-12);
    EXPECT_NEAR(glm::distance(scene.pointLights[0].position, place), 0.0, 1e-12);
    EXPECT_NEAR(glm::distance(scene.directionalLights[0].direction, down), 0.0, 1e-12);
    EXPECT_NEAR(glm::distance(scene.cameras[0].frame.forward(), down), 0.0, 1e-12);
}

TEST(PlaceNodes, WhatHangsOnNoNodeStays) {
    Scene scene = rig();
    scene.spotLights.emplace_back().frame.position = {7.0, 8.0, 9.0};
    placeNodes(scene);
    EXPECT_EQ(scene.spotLights[0].frame.position, glm::dvec3(7.0, 8.0, 9.0));
}

TEST(SceneBounds, CoversEveryUseOfAMesh) {
    Scene scene = rig();
    placeNodes(scene);
    EXPECT_TRUE(sceneBounds(scene).isEmpty());
    Primitive primitive;
    primitive.bounds = {glm::dvec3(-1.0), glm::dvec3(1.0)};
    scene.meshes.push_back({"box", {primitive, Primitive{}}});
    scene.nodes[0].mesh = 0;
    scene.nodes[1].mesh = 0;
    const Bounds bounds = sceneBounds(scene);
    EXPECT_NEAR(glm::distance(bounds.low, glm::dvec3(-1.0, 5.0, -1.0)), 0.0, 1e-12);
    EXPECT_NEAR(glm::distance(bounds.high, glm::dvec3(3.0, 7.0, 1.0)), 0.0, 1e-12);
}

}  // namespace
}  // namespace ribalta
