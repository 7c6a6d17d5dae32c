// Cameras, right and wrong.
#include <cmath>

#include <gtest/gtest.h>

#include "gltf_file.h"

namespace ribalta::test {
namespace {

using nlohmann::json;

GltfFile fileWithCamera(const json& camera) {
    GltfFile file = triangleFile();
    file.addNode({{"camera", file.push("cameras", camera)}, {"translation", {1, 2, 3}}});
    return file;
}

TEST(GltfCameraTest, Perspective) {
    const LoadedScene loaded = load(fileWithCamera(
        {{"name", "front"},
         {"type", "perspective"},
         {"perspective", {{"yfov", 0.5}, {"aspectRatio", 1.5}, {"znear", 0.2}, {"zfar", 90}}}}));
    ASSERT_EQ(loaded.scene.cameras.size(), 1U);
    const Camera& camera = loaded.scene.cameras[0];
    const auto& lens = std::get<PerspectiveLens>(camera.lens);
    EXPECT_EQ(camera.name, "front");
    EXPECT_EQ(camera.node, 1);
    EXPECT_EQ(camera.frame.position, glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_EQ(lens.verticalFov, 0.5);
    EXPECT_EQ(lens.aspectRatio, 1.5);
    EXPECT_EQ(camera.nearMetres, 0.2);
    EXPECT_EQ(camera.farMetres, 90.0);
    EXPECT_EQ(reportText(loaded), "");
}

TEST(GltfCameraTest, WithoutFarSeesToInfinity) {
    const LoadedScene loaded = load(fileWithCamera(
        {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.2}}}}));
    EXPECT_TRUE(std::isinf(loaded.scene.cameras.at(0).farMetres));
    EXPECT_FALSE(std::get<PerspectiveLens>(loaded.scene.cameras[0].lens).aspectRatio);
    EXPECT_EQ(loaded.scene.cameras[0].name, "camera_0");
}

TEST(GltfCameraTest, Orthographic) {
    const LoadedScene loaded = load(
        fileWithCamera({{"type", "orthographic"},
                        {"orthographic", {{"xmag", 3}, {"ymag", 2}, {"znear", 0}, {"zfar", 10}}}}));
    const auto& lens = std::get<OrthographicLens>(loaded.scene.cameras.at(0).lens);
    EXPECT_EQ(lens.halfWidth, 3.0);
    EXPECT_EQ(lens.halfHeight, 2.0);
    EXPECT_EQ(loaded.scene.cameras[0].nearMetres, 0.0);
    EXPECT_EQ(loaded.scene.cameras[0].farMetres, 10.0);
}

TEST(GltfCameraTest, TheNodesNameComesFirst) {
    GltfFile file = fileWithCamera(
        {{"name", "lens"}, {"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}});
    file.json["nodes"][1]["name"] = "front_of_house";
    EXPECT_EQ(load(file).scene.cameras.at(0).name, "front_of_house");
}

TEST(GltfCameraTest, BlendersSuffixIsNoPartOfTheName) {
    GltfFile file = fileWithCamera(
        {{"name", "stand"}, {"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}});
    file.json["nodes"][1]["name"] = "stand.020";
    EXPECT_EQ(load(file).scene.cameras.at(0).name, "stand");
    // Another camera stands on a node of that name.
    file.addNode({{"name", "stand"}, {"camera", 0}});
    const LoadedScene loaded = load(file);
    EXPECT_EQ(loaded.scene.cameras.at(0).name, "stand.020");
    EXPECT_EQ(loaded.scene.cameras.at(1).name, "stand");
}

TEST(GltfCameraTest, ValuesThatMakeNoPictureAreReplaced) {
    const LoadedScene perspective = load(fileWithCamera(
        {{"type", "perspective"},
         {"perspective", {{"yfov", 0}, {"znear", 0}, {"zfar", -1}, {"aspectRatio", -2}}}}));
    for (const char* key : {"yfov", "znear", "zfar", "aspectRatio"}) {
        expectLine(perspective, Report::Kind::kRepaired,
                   std::string("/cameras/0/perspective/") + key, "no picture");
    }
    const LoadedScene orthographic = load(
        fileWithCamera({{"type", "orthographic"},
                        {"orthographic", {{"xmag", -3}, {"ymag", 0}, {"znear", 5}, {"zfar", 1}}}}));
    EXPECT_EQ(std::get<OrthographicLens>(orthographic.scene.cameras.at(0).lens).halfWidth, 3.0);
    for (const char* key : {"xmag", "ymag", "zfar"}) {
        expectLine(orthographic, Report::Kind::kRepaired,
                   std::string("/cameras/0/orthographic/") + key, "no picture");
    }
    expectLine(load(fileWithCamera({{"type", "perspective"}})), Report::Kind::kRepaired,
               "/cameras/0", "lacks its \"perspective\"");
}

}  // namespace
}  // namespace ribalta::test
