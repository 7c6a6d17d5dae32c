// EXT_mesh_gpu_instancing against the same file with a node for each instance, and
// KHR_node_visibility.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "gltf_file.h"

namespace ribalta::test {
namespace {

using nlohmann::json;

const std::vector<float> kTranslations = {0, 0, 0, 2, 0, 0, 0, 3, -1};
const std::vector<float> kRotations = {0, 0, 0, 1, 0, 0.6F, 0, 0.8F, 0.6F, 0, 0, 0.8F};
const std::vector<float> kScales = {1, 1, 1, 2, 1, 1, 1, -1, 3};

// A triangle whose node stands below another one, both placed and turned.
struct PlacedFile : GltfFile {
    PlacedFile() : GltfFile(triangleFile()) {
        json["nodes"][0].update({{"translation", {1, 2, 3}}, {"scale", {2, 2, 2}}});
        const int parent = push("nodes", {{"children", {0}}, {"rotation", {0, 0, 0.6, 0.8}}});
        json["scenes"][0]["nodes"] = {parent};
    }
    nlohmann::json& instancing() {
        return json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"];
    }
};

PlacedFile instancedFile() {
    PlacedFile file;
    json attributes;
    attributes["TRANSLATION"] = file.addAccessor(kTranslations, "VEC3", kFloat, 3);
    attributes["ROTATION"] = file.addAccessor(kRotations, "VEC4", kFloat, 3);
    attributes["SCALE"] = file.addAccessor(kScales, "VEC3", kFloat, 3);
    file.instancing()["attributes"] = attributes;
    file.json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
    file.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    return file;
}

// The same without the extension.
PlacedFile expandedFile() {
    PlacedFile file;
    file.json["nodes"][0].erase("mesh");
    for (std::size_t i = 0; i < 3; ++i) {
        const auto part = [&](const std::vector<float>& from, std::size_t length) {
            return json(std::vector<float>(from.begin() + std::ptrdiff_t(i * length),
                                           from.begin() + std::ptrdiff_t((i + 1) * length)));
        };
        const int child = file.push("nodes", {{"mesh", 0},
                                              {"translation", part(kTranslations, 3)},
                                              {"rotation", part(kRotations, 4)},
                                              {"scale", part(kScales, 3)}});
        file.json["nodes"][0]["children"].push_back(child);
    }
    return file;
}

std::vector<glm::dmat4> drawnPlaces(const Scene& scene) {
    std::vector<glm::dmat4> places;
    for (const Node& node : scene.nodes) {
        if (node.isDrawn()) {
            places.push_back(node.worldFromLocal);
        }
    }
    return places;
}

void expectSamePlaces(const Scene& scene, const Scene& other, double tolerance) {
    const auto places = drawnPlaces(scene);
    const auto expected = drawnPlaces(other);
    ASSERT_EQ(places.size(), expected.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        for (int column = 0; column < 4; ++column) {
            EXPECT_LE(glm::distance(places[i][column], expected[i][column]), tolerance)
                << i << " column " << column;
        }
    }
}

TEST(InstancesTest, AreTheNodesThatTheyStandFor) {
    const LoadedScene loaded = load(instancedFile());
    EXPECT_EQ(reportText(loaded), "");
    expectSamePlaces(loaded.scene, load(expandedFile()).scene, 1e-6);
    EXPECT_EQ(loaded.scene.meshes.size(), 1U);
}

TEST(InstancesTest, RotationsOfEveryComponentType) {
    for (const int type : {kByte, kShort}) {
        const double most = type == kByte ? 127.0 : 32767.0;
        PlacedFile file = instancedFile();
        std::vector<std::int8_t> bytes;
        std::vector<std::int16_t> shorts;
        for (const float x : kRotations) {
            bytes.push_back(std::int8_t(std::lround(x * 127.0)));
            shorts.push_back(std::int16_t(std::lround(x * 32767.0)));
        }
        const int accessor = type == kByte ? file.addAccessor(bytes, "VEC4", kByte, 3)
                                           : file.addAccessor(shorts, "VEC4", kShort, 3);
        file.json["accessors"][std::size_t(accessor)]["normalized"] = true;
        file.instancing()["attributes"]["ROTATION"] = accessor;
        const LoadedScene loaded = load(file);
        EXPECT_EQ(reportText(loaded), "");
        // Half a step in four parts of a quaternion, twice that as an angle, a node six wide.
        expectSamePlaces(loaded.scene, load(expandedFile()).scene, 12.0 / most);
    }
}

TEST(InstancesTest, MoveWithTheirNode) {
    PlacedFile file = instancedFile();
    const int input = file.addAccessor(std::vector<float>{0, 1}, "SCALAR", kFloat, 2);
    const int output = file.addAccessor(std::vector<float>{1, 2, 3, 5, 2, 3}, "VEC3", kFloat, 2);
    file.json["animations"] = {
        {{"samplers", {{{"input", input}, {"output", output}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
    LoadedScene loaded = load(file);
    const auto before = drawnPlaces(loaded.scene);
    poseScene(loaded.scene, 1.0);
    const auto after = drawnPlaces(loaded.scene);
    ASSERT_EQ(before.size(), 3U);
    // 4 m along x of a parent that is turned by 2 acos(0.8) about z.
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(after[i][3].x - before[i][3].x, 4.0 * 0.28, 1e-6);
        EXPECT_NEAR(after[i][3].y - before[i][3].y, 4.0 * 0.96, 1e-6);
    }
}

TEST(InstancesTest, CarryTheMeshAlone) {
    PlacedFile file = instancedFile();
    file.json["extensionsUsed"].push_back("KHR_lights_punctual");
    file.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
    file.json["nodes"][0]["extensions"]["KHR_lights_punctual"] = {{"light", 0}};
    EXPECT_EQ(load(file).scene.pointLights.size(), 1U);
}

TEST(InstancesTest, WhatCannotStandAnywhereIsLeftOut) {
    PlacedFile file = instancedFile();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    file.instancing()["attributes"]["TRANSLATION"] =
        file.addAccessor(std::vector<float>{0, 0, 0, nan, 0, 0, 1, 1, 1}, "VEC3", kFloat, 3);
    file.instancing()["attributes"]["SCALE"] =
        file.addAccessor(std::vector<float>{1, 1, 1, 1, 1, 1, 0, 0, 0}, "VEC3", kFloat, 3);
    const LoadedScene loaded = load(file);
    EXPECT_EQ(drawnPlaces(loaded.scene).size(), 1U);
    const std::string pointer = "/nodes/0/extensions/EXT_mesh_gpu_instancing";
    expectLine(loaded, Report::Kind::kIgnored, pointer, "1 instance of 3 placed by numbers");
    expectLine(loaded, Report::Kind::kIgnored, pointer, "1 instance of 3 scaled to nothing");
}

TEST(InstancesTest, BrokenAttributesCostTheInstances) {
    const std::string pointer = "/nodes/0/extensions/EXT_mesh_gpu_instancing";
    const auto once = [&](const PlacedFile& file, const std::string& at, const std::string& word) {
        const LoadedScene loaded = load(file);
        EXPECT_EQ(drawnPlaces(loaded.scene).size(), 1U);
        expectLine(loaded, Report::Kind::kIgnored, at, word);
        expectLine(loaded, Report::Kind::kIgnored, at, "drawn once");
    };
    PlacedFile file = instancedFile();
    file.instancing()["attributes"]["SCALE"] = 99;
    once(file, pointer + "/attributes/SCALE", "is 99");
    file = instancedFile();
    file.instancing()["attributes"]["SCALE"] =
        file.addAccessor(std::vector<float>{1, 1, 1}, "VEC3", kFloat, 1);
    once(file, pointer + "/attributes/SCALE", "has 1 element");
    file = instancedFile();
    file.instancing().erase("attributes");
    once(file, pointer, "no attributes");
    file = instancedFile();
    file.instancing()["attributes"] = {
        {"TRANSLATION",
         file.push("accessors",
                   {{"componentType", kFloat}, {"type", "VEC3"}, {"count", (1 << 20U) + 1}})}};
    once(file, pointer + "/attributes", "the most that are drawn");
}

TEST(InstancesTest, CustomAttributesAreSaid) {
    PlacedFile file = instancedFile();
    file.instancing()["attributes"]["_ID"] =
        file.addAccessor(std::vector<float>{1, 2, 3}, "SCALAR", kFloat, 3);
    const LoadedScene loaded = load(file);
    EXPECT_EQ(drawnPlaces(loaded.scene).size(), 3U);
    expectLine(loaded, Report::Kind::kIgnored,
               "/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/_ID", "not used");
}

TEST(NodeVisibilityTest, HidesAllBelowButCameras) {
    PlacedFile file;
    file.json["extensionsUsed"] = {"KHR_node_visibility", "KHR_lights_punctual"};
    file.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "spot"}, {"spot", json::object()}}, {{"type", "point"}}};
    file.json["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}}};
    file.json["nodes"][0]["camera"] = 0;
    file.json["nodes"][0]["extensions"] = {{"KHR_lights_punctual", {{"light", 0}}},
                                           {"KHR_node_visibility", {{"visible", true}}}};
    file.json["nodes"][1]["extensions"]["KHR_node_visibility"]["visible"] = false;
    file.addNode({{"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}});
    const LoadedScene loaded = load(file);
    EXPECT_EQ(reportText(loaded), "");
    EXPECT_TRUE(sceneBounds(loaded.scene).isEmpty());
    EXPECT_TRUE(drawnPlaces(loaded.scene).empty());
    ASSERT_EQ(loaded.scene.spotLights.size(), 1U);
    EXPECT_FALSE(loaded.scene.spotLights[0].shown);
    EXPECT_TRUE(loaded.scene.pointLights.at(0).shown);
    EXPECT_EQ(loaded.scene.cameras.size(), 1U);

    file.json["nodes"][1]["extensions"]["KHR_node_visibility"]["visible"] = "no";
    const LoadedScene mended = load(file);
    expectLine(mended, Report::Kind::kRepaired, "/nodes/1/extensions/KHR_node_visibility/visible",
               "true or false");
    EXPECT_TRUE(mended.scene.spotLights[0].shown);
}

}  // namespace
}  // namespace ribalta::test
