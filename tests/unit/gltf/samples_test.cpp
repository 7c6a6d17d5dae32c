// The project's own scenes, as their scripts in samples/scenes/source make them.
#include <algorithm>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "gltf_file.h"

namespace ribalta::test {
namespace {

LoadedScene loadSample(const std::string& name) {
    return load(std::filesystem::path(RIBALTA_SOURCE_DIR) / "samples/scenes" / name);
}

std::size_t triangles(const Scene& scene) {
    std::size_t count = 0;
    for (const Mesh& mesh : scene.meshes) {
        for (const Primitive& primitive : mesh.primitives) {
            count += primitive.indices.size() / 3;
        }
    }
    return count;
}

bool hasCamera(const Scene& scene, const std::string& name) {
    return std::any_of(scene.cameras.begin(), scene.cameras.end(),
                       [&](const Camera& camera) { return camera.name == name; });
}

std::map<std::string, std::string> lightMaps(const Scene& scene) {
    std::map<std::string, std::string> maps;
    for (const SpotLight& spot : scene.spotLights) {
        maps[spot.name] =
            spot.lightMap ? scene.images.at(std::size_t(spot.lightMap->image)).name : "";
    }
    return maps;
}

TEST(SamplesTest, Stage) {
    const LoadedScene loaded = loadSample("stage.glb");
    const Scene& scene = loaded.scene;
    EXPECT_EQ(triangles(scene), 233056U);
    EXPECT_TRUE(hasCamera(scene, "front_of_house"));
    EXPECT_TRUE(hasCamera(scene, "side_stage"));
    const std::map<std::string, std::string> expected = {
        {"spot_0", "gobo_window.png"},
        {"spot_1", "gobo_star.png"},
        {"spot_2", "gobo_leaves.png"},
        {"spot_3", "gobo_dots.png"},
        {"spot_4", ""},
        {"spot_5", "gobo_window.png"},
        {"spot_6", "gobo_star.png"},
        {"spot_7", "gobo_leaves.png"},
        {"spot_8", "gobo_dots.png"},
        {"spot_9", ""},
        {"spot_10", ""},
        {"spot_11", ""},
    };
    EXPECT_EQ(lightMaps(scene), expected);
    EXPECT_EQ(scene.images.size(), 4U);
    EXPECT_NEAR(scene.spotLights.at(0).intensityCandela, 489162.7, 0.1);
    EXPECT_EQ(reportText(loaded), "");
    // Blender's stage floor: 16 m wide, 10 m deep.
    const Bounds bounds = sceneBounds(scene);
    EXPECT_FALSE(bounds.isEmpty());
    EXPECT_GT(bounds.high.x - bounds.low.x, 15.0);
}

TEST(SamplesTest, Festival) {
    const LoadedScene loaded = loadSample("festival.glb");
    EXPECT_EQ(loaded.scene.spotLights.size(), 24U);
    EXPECT_EQ(loaded.scene.directionalLights.size(), 1U);
    EXPECT_TRUE(hasCamera(loaded.scene, "audience"));
    EXPECT_TRUE(hasCamera(loaded.scene, "drone"));
    EXPECT_EQ(reportText(loaded), "");
}

TEST(SamplesTest, Arena) {
    LoadedScene loaded = loadSample("arena.glb");
    EXPECT_EQ(loaded.scene.spotLights.size(), 128U);
    EXPECT_TRUE(hasCamera(loaded.scene, "stand"));
    EXPECT_TRUE(hasCamera(loaded.scene, "pit"));
    EXPECT_EQ(reportText(loaded), "");
}

// make_arena.py: head i aims at a point of the floor that goes around in 8 s.
TEST(SamplesTest, ArenaHeadsFollowTheirCourse) {
    LoadedScene loaded = loadSample("arena.glb");
    ASSERT_EQ(loaded.scene.animations.size(), 128U);
    EXPECT_EQ(durationSeconds(loaded.scene), 8.0);
    // Keys stand a third of a second apart.
    for (const double seconds : {0.0, 1.0, 4.0, 7.0}) {
        poseScene(loaded.scene, seconds);
        for (const int head : {0, 5, 40, 127}) {
            const std::string name = "head_" + std::to_string(head);
            const auto lamp =
                std::find_if(loaded.scene.spotLights.begin(), loaded.scene.spotLights.end(),
                             [&](const SpotLight& spot) { return spot.name == name; });
            ASSERT_NE(lamp, loaded.scene.spotLights.end());
            const int row = head / 32;
            const double phase = 2.0 * std::numbers::pi * seconds / 8.0 + 0.35 * head;
            // Blender's (x, y, z) is glTF's (x, z, -y).
            const glm::dvec3 place = lamp->frame.position;
            const glm::dvec3 target(place.x + 7.0 * std::sin(phase), 0.0,
                                    place.z + 6.0 - 6.0 * std::cos(2.0 * phase + row));
            EXPECT_NEAR(glm::distance(lamp->frame.forward(), glm::normalize(target - place)), 0.0,
                        1e-4)
                << name << " at " << seconds << " s";
        }
    }
}

}  // namespace
}  // namespace ribalta::test
