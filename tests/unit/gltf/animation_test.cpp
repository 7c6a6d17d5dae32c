// Animations as files hold them: what is read, what is left out, and what is said of it.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "gltf/read_sampler.h"
#include "gltf_file.h"

namespace ribalta::test {
namespace {

using nlohmann::json;
using Interpolation = AnimationSampler::Interpolation;

/// A triangle, and animation 0 of it: from x = 0 to x = 4 in 2 s.
struct AnimatedFile : GltfFile {
    AnimatedFile() : GltfFile(triangleFile()) {
        json["animations"] = nlohmann::json::array({{{"name", "slide"},
                                                     {"samplers", nlohmann::json::array()},
                                                     {"channels", nlohmann::json::array()}}});
        // Accessors 1 and 2; 0 is the triangle's.
        const int input = addAccessor(std::vector<float>{0, 2}, "SCALAR", kFloat, 2);
        const int output = addAccessor(std::vector<float>{0, 0, 0, 4, 0, 0}, "VEC3", kFloat, 2);
        addChannel("translation", addSampler(input, output));
    }

    int addSampler(int input, int output, const std::string& interpolation = "LINEAR") {
        auto& list = json["animations"][0]["samplers"];
        list.push_back({{"input", input}, {"output", output}, {"interpolation", interpolation}});
        return int(list.size()) - 1;
    }
    void addChannel(const std::string& path, int sampler, int node = 0) {
        json["animations"][0]["channels"].push_back(
            {{"sampler", sampler}, {"target", {{"node", node}, {"path", path}}}});
    }
    nlohmann::json& accessorOf(const char* end) {
        return json["accessors"][json["animations"][0]["samplers"][0][end].get<std::size_t>()];
    }
};

std::size_t channelsOf(const LoadedScene& loaded) {
    std::size_t count = 0;
    for (const Animation& animation : loaded.scene.animations) {
        count += animation.channels.size();
    }
    return count;
}

// Nothing is played, and a line at the pointer says why.
void expectLeftOut(const GltfFile& file, const std::string& pointer, const std::string& word) {
    const LoadedScene loaded = load(file);
    EXPECT_EQ(channelsOf(loaded), 0U);
    expectLine(loaded, Report::Kind::kIgnored, pointer, word);
}

double xAt(Scene& scene, double seconds) {
    poseScene(scene, seconds);
    return scene.nodes.at(0).worldFromLocal[3].x;
}

TEST(GltfAnimationTest, SlideIsPlayedAndTheSceneStandsAtRest) {
    AnimatedFile file;
    file.json["nodes"][0]["translation"] = {7, 1, 0};
    file.json["nodes"][0]["scale"] = {2, 2, 2};
    LoadedScene loaded = load(file);
    EXPECT_EQ(reportText(loaded), "");
    ASSERT_EQ(loaded.scene.animations.size(), 1U);
    EXPECT_EQ(loaded.scene.animations[0].name, "slide");
    EXPECT_EQ(durationSeconds(loaded.scene), 2.0);
    EXPECT_EQ(loaded.scene.nodes[0].worldFromLocal[3].x, 7.0);
    EXPECT_EQ(xAt(loaded.scene, 0.5), 1.0);
    // The other parts stay as they are in the file.
    EXPECT_EQ(loaded.scene.nodes[0].worldFromLocal[0].x, 2.0);
    restScene(loaded.scene);
    EXPECT_EQ(loaded.scene.nodes[0].worldFromLocal[3].x, 7.0);
}

TEST(GltfAnimationTest, RotationsOfEveryComponentType) {
    // A turn of 180 degrees about z at the second key.
    const auto turned = [](AnimatedFile& file, int output, bool normalized) {
        file.json["animations"][0]["samplers"].clear();
        file.json["animations"][0]["channels"].clear();
        file.json["accessors"][std::size_t(output)]["normalized"] = normalized;
        const int input = file.addAccessor(std::vector<float>{0, 1}, "SCALAR", kFloat, 2);
        file.addChannel("rotation", file.addSampler(input, output, "STEP"));
        LoadedScene loaded = load(file);
        EXPECT_EQ(reportText(loaded), "");
        poseScene(loaded.scene, 1.0);
        return loaded.scene.nodes.at(0).worldFromLocal[0].x;
    };
    AnimatedFile file;
    EXPECT_NEAR(
        turned(file,
               file.addAccessor(std::vector<float>{0, 0, 0, 1, 0, 0, 1, 0}, "VEC4", kFloat, 2),
               false),
        -1.0, 1e-6);
    EXPECT_NEAR(turned(file,
                       file.addAccessor(std::vector<std::int8_t>{0, 0, 0, 127, 0, 0, -127, 0},
                                        "VEC4", 5120, 2),
                       true),
                -1.0, 1e-6);
    EXPECT_NEAR(turned(file,
                       file.addAccessor(std::vector<std::uint8_t>{0, 0, 0, 255, 0, 0, 255, 0},
                                        "VEC4", 5121, 2),
                       true),
                -1.0, 1e-6);
    EXPECT_NEAR(turned(file,
                       file.addAccessor(std::vector<std::int16_t>{0, 0, 0, 32767, 0, 0, 32767, 0},
                                        "VEC4", 5122, 2),
                       true),
                -1.0, 1e-6);
    EXPECT_NEAR(turned(file,
                       file.addAccessor(std::vector<std::uint16_t>{0, 0, 0, 65535, 0, 0, 65535, 0},
                                        "VEC4", 5123, 2),
                       true),
                -1.0, 1e-6);
}

TEST(GltfAnimationTest, IntegersThatAreNotNormalizedAreLeftOut) {
    AnimatedFile file;
    file.accessorOf("output").update({{"componentType", 5122}});
    expectLeftOut(file, "/accessors/2", "normalized");
}

TEST(GltfAnimationTest, SplinesHaveThreeValuesAKey) {
    AnimatedFile file;
    auto& sampler = file.json["animations"][0]["samplers"][0];
    sampler["interpolation"] = "CUBICSPLINE";
    expectLeftOut(file, "/accessors/2/count", "expected three for each of the 2 keys");
    // From 0 with the tangent 2 to 4 with the tangent 0, 2 s: halfway 0.25 * 2 + 0.5 * 4.
    sampler["output"] =
        file.addAccessor(std::vector<float>{9, 9, 9, 0, 0, 0, 2, 0, 0, 0, 0, 0, 4, 0, 0, 9, 9, 9},
                         "VEC3", kFloat, 6);
    LoadedScene loaded = load(file);
    EXPECT_EQ(reportText(loaded), "");
    EXPECT_NEAR(xAt(loaded.scene, 1.0), 2.5, 1e-12);
}

TEST(GltfAnimationTest, SharedSamplersAreReadOnce) {
    AnimatedFile file;
    file.addNode({{"mesh", 0}});
    file.addChannel("translation", 0, 1);
    file.addChannel("scale", 0, 1);
    const LoadedScene loaded = load(file);
    EXPECT_EQ(channelsOf(loaded), 3U);
    EXPECT_EQ(loaded.scene.animations[0].samplers.size(), 1U);
    EXPECT_EQ(loaded.scene.movers.size(), 2U);
}

TEST(GltfAnimationTest, CountsThatDoNotFitAreLeftOut) {
    AnimatedFile file;
    file.accessorOf("output")["count"] = 1;
    expectLeftOut(file, "/accessors/2/count", "expected one for each of the 2 keys");
}

TEST(GltfAnimationTest, TimesThatDoNotIncreaseAreLeftOut) {
    for (const std::vector<float>& times :
         {std::vector<float>{1, 1}, std::vector<float>{2, 1},
          std::vector<float>{0, std::numeric_limits<float>::quiet_NaN()},
          std::vector<float>{0, std::numeric_limits<float>::infinity()}}) {
        AnimatedFile file;
        file.json["animations"][0]["samplers"][0]["input"] =
            file.addAccessor(times, "SCALAR", kFloat, 2);
        expectLeftOut(file, "/accessors/3", "at key 1");
    }
}

TEST(GltfAnimationTest, TimesBeforeZeroAreAHint) {
    AnimatedFile file;
    file.json["animations"][0]["samplers"][0]["input"] =
        file.addAccessor(std::vector<float>{-1, 1}, "SCALAR", kFloat, 2);
    LoadedScene loaded = load(file);
    expectLine(loaded, Report::Kind::kHint, "/accessors/3", "below 0");
    EXPECT_EQ(xAt(loaded.scene, 0.0), 2.0);
}

TEST(GltfAnimationTest, TypesThatDoNotFitAreLeftOut) {
    AnimatedFile file;
    file.accessorOf("input")["componentType"] = 5125;
    expectLeftOut(file, "/accessors/1", "float scalars");
    AnimatedFile other;
    other.json["animations"][0]["channels"][0]["target"]["path"] = "rotation";
    expectLeftOut(other, "/accessors/2/type", "VEC4");
}

TEST(GltfAnimationTest, ValuesThatAreNoneAreLeftOut) {
    AnimatedFile file;
    file.json["animations"][0]["samplers"][0]["output"] =
        file.addAccessor(std::vector<float>{0, 0, 0, 0, std::numeric_limits<float>::infinity(), 0},
                         "VEC3", kFloat, 2);
    expectLeftOut(file, "/accessors/3", "not finite at element 1");
    AnimatedFile turn;
    turn.json["animations"][0]["samplers"][0]["output"] =
        turn.addAccessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 0}, "VEC4", kFloat, 2);
    turn.json["animations"][0]["channels"][0]["target"]["path"] = "rotation";
    expectLeftOut(turn, "/accessors/3", "no rotation at element 1");
}

TEST(GltfAnimationTest, KeysPastTheirBufferAreLeftOut) {
    AnimatedFile file;
    file.accessorOf("input")["count"] = 200;
    file.accessorOf("output")["count"] = 200;
    expectLeftOut(file, "/accessors/1", "needs 200 elements");
}

TEST(GltfAnimationTest, TooManyValuesAreLeftOut) {
    AnimatedFile file;
    const std::size_t count = gltf::kMaxAnimationValues + 1;
    for (const char* end : {"input", "output"}) {
        file.accessorOf(end)["count"] = count;
    }
    expectLeftOut(file, "/accessors/2", "at most");
}

TEST(GltfAnimationTest, NodesThatDoNotMoveAreToldOnce) {
    AnimatedFile matrix;
    matrix.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1};
    matrix.addChannel("scale", 0);
    expectLeftOut(matrix, "/animations/0/channels/0/target/node", "matrix");
    EXPECT_EQ(load(matrix).report.entries().size(), 1U);

    AnimatedFile elsewhere;
    elsewhere.push("nodes", {{"name", "of no scene"}});
    elsewhere.json["animations"][0]["channels"][0]["target"]["node"] = 1;
    expectLeftOut(elsewhere, "/animations/0/channels/0/target/node", "another scene");

    AnimatedFile nowhere;
    nowhere.json["animations"][0]["channels"][0]["target"].erase("node");
    expectLeftOut(nowhere, "/animations/0/channels/0/target", "names no node");
}

TEST(GltfAnimationTest, OtherPathsAreTold) {
    const std::string place = "/animations/0/channels/0/target/path";
    for (const auto& [path, word] : {std::pair("pointer", "the target has none in extensions"),
                                     {"colour", "none of translation"}}) {
        AnimatedFile file;
        file.json["animations"][0]["channels"][0]["target"]["path"] = path;
        expectLeftOut(file, place, word);
    }
}

TEST(GltfAnimationTest, BrokenJsonCostsTheChannel) {
    const auto broken = [](const char* where, const json& value) {
        AnimatedFile file;
        file.json["animations"][0][json::json_pointer(where)] = value;
        return file;
    };
    const std::string first = "/animations/0";
    expectLeftOut(broken("/channels/0/sampler", 7), first + "/channels/0/sampler", "1 sampler");
    expectLeftOut(broken("/channels/0/sampler", "x"), first + "/channels/0/sampler", "integer");
    expectLeftOut(broken("/channels/0/target/node", 9), first + "/channels/0/target/node",
                  "1 node");
    expectLeftOut(broken("/channels/0", 3), first + "/channels/0", "no object");
    expectLeftOut(broken("/channels", 3), first, "list of channels");
    expectLeftOut(broken("/samplers/0/input", 99), first + "/samplers/0/input", "accessors");
    expectLeftOut(broken("/samplers/0/interpolation", "BEZIER"),
                  first + "/samplers/0/interpolation", "CUBICSPLINE");
    expectLeftOut(broken("/samplers/0", nullptr), first + "/samplers/0", "no object");
    AnimatedFile file;
    file.json["animations"] = 5;
    expectLeftOut(file, "/animations", "no list");
    file.json["animations"] = json::array({5});
    expectLeftOut(file, "/animations/0", "no object");
}

TEST(GltfAnimationTest, OnePartIsMovedOnce) {
    AnimatedFile file;
    file.addChannel("translation", 0);
    const LoadedScene loaded = load(file);
    EXPECT_EQ(channelsOf(loaded), 1U);
    expectLine(loaded, Report::Kind::kIgnored, "/animations/0/channels/1/target", "already");
}

TEST(GltfAnimationTest, RivalsAreAHint) {
    AnimatedFile file;
    file.json["animations"].push_back(file.json["animations"][0]);
    const LoadedScene loaded = load(file);
    EXPECT_EQ(channelsOf(loaded), 2U);
    expectLine(loaded, Report::Kind::kHint, "/animations/1", "--animation");
}

TEST(GltfAnimationTest, MeshThatGrowsFromNothingIsKept) {
    AnimatedFile file;
    file.json["nodes"][0]["scale"] = {0, 0, 0};
    file.json["animations"][0]["channels"][0]["target"]["path"] = "scale";
    const LoadedScene loaded = load(file);
    EXPECT_EQ(reportText(loaded), "");
    EXPECT_EQ(loaded.scene.nodes.at(0).mesh, 0);
    EXPECT_TRUE(vanishes(loaded.scene.nodes[0].worldFromLocal));
}

TEST(GltfAnimationTest, MotionOutOfAllBoundsIsNotPlayed) {
    AnimatedFile file;
    auto& channel = file.json["animations"][0]["channels"][0];
    channel["target"]["path"] = "scale";
    file.json["animations"][0]["samplers"][0]["output"] =
        file.addAccessor(std::vector<float>{1, 1, 1, 1e20F, 1e20F, 1e20F}, "VEC3", kFloat, 2);
    EXPECT_EQ(channelsOf(load(file)), 1U);
    file.json["nodes"][0]["children"] = {1};
    file.push("nodes", {{"scale", {1e15, 1, 1}}});
    expectLeftOut(file, "/animations", "node 1");
}

}  // namespace
}  // namespace ribalta::test
