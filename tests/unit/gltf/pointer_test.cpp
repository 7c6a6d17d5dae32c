// KHR_animation_pointer: what of lamps, cameras, materials and nodes is animated, within which
// limits, and what is said of the rest.
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "gltf/animation_pointer.h"
#include "gltf_file.h"

namespace ribalta::test {
namespace {

using nlohmann::json;

constexpr int kFloat = 5126;
constexpr int kByte = 5121;
const std::string kLight = "/extensions/KHR_lights_punctual/lights/0";
const std::string kAim = "/animations/0/channels/0/target/extensions/KHR_animation_pointer/pointer";

/// A triangle, a spot, a camera of each kind; and pointers that are played from 0 to 2 s.
struct PointedFile : GltfFile {
    PointedFile() : GltfFile(triangleFile()) {
        json["extensionsUsed"] = {"KHR_animation_pointer", "KHR_lights_punctual",
                                  "KHR_materials_emissive_strength", "KHR_node_visibility"};
        json["materials"] = {{{"pbrMetallicRoughness", nlohmann::json::object()}}};
        json["meshes"][0]["primitives"][0]["material"] = 0;
        json["extensions"]["KHR_lights_punctual"]["lights"] = {
            {{"type", "spot"},
             {"intensity", 1000},
             {"range", 50},
             {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.4}}}}};
        addLampNode(0);
        json["cameras"] = {
            {{"type", "perspective"},
             {"perspective", {{"yfov", 0.5}, {"znear", 0.1}, {"zfar", 100}, {"aspectRatio", 1.5}}}},
            {{"type", "orthographic"},
             {"orthographic", {{"xmag", 2}, {"ymag", 1}, {"znear", 1}, {"zfar", 10}}}}};
        addNode({{"camera", 0}});
        addNode({{"camera", 1}});
        json["animations"] = {
            {{"samplers", nlohmann::json::array()}, {"channels", nlohmann::json::array()}}};
    }

    void addLampNode(int light) {
        addNode({{"extensions", {{"KHR_lights_punctual", {{"light", light}}}}}});
    }
    nlohmann::json& animation() { return json["animations"][0]; }
    /// Keys at 0 s and 2 s.
    int addSampler(int output, const std::string& interpolation = "LINEAR") {
        const int input = addAccessor(std::vector<float>{0, 2}, "SCALAR", kFloat, 2);
        animation()["samplers"].push_back(
            {{"input", input}, {"output", output}, {"interpolation", interpolation}});
        return int(animation()["samplers"].size()) - 1;
    }
    int addFloats(const std::vector<float>& numbers, std::size_t count = 2) {
        const std::size_t width = numbers.size() / count;
        const char* const types[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
        return addAccessor(numbers, types[width - 1], kFloat, count);
    }
    void point(const std::string& pointer, int sampler) {
        animation()["channels"].push_back(
            {{"sampler", sampler},
             {"target",
              {{"path", "pointer"},
               {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}}}});
    }
    void point(const std::string& pointer, const std::vector<float>& numbers,
               const std::string& interpolation = "LINEAR") {
        const std::size_t keys = interpolation == "CUBICSPLINE" ? 6 : 2;
        point(pointer, addSampler(addFloats(numbers, keys), interpolation));
    }
};

Scene posed(const LoadedScene& loaded, double seconds) {
    Scene scene = loaded.scene;
    poseScene(scene, seconds);
    return scene;
}

// Halfway from the first key to the last.
Scene halfway(const PointedFile& file) {
    const LoadedScene loaded = load(file);
    EXPECT_EQ(reportText(loaded), "");
    return posed(loaded, 1.0);
}

std::size_t channelsOf(const LoadedScene& loaded) {
    return loaded.scene.animations.at(0).channels.size();
}

// The one pointer is not played, and a line at the place says why.
void expectLeftOut(const GltfFile& file, const std::string& place, const std::string& word) {
    const LoadedScene loaded = load(file);
    EXPECT_EQ(channelsOf(loaded), 0U);
    expectLine(loaded, Report::Kind::kIgnored, place, word);
}

TEST(PointerTest, Lamps) {
    PointedFile file;
    file.point(kLight + "/intensity", {100, 300});
    file.point(kLight + "/color", {1, 0, 0, 0, 0, 1});
    file.point(kLight + "/range", {10, 30});
    file.point(kLight + "/spot/innerConeAngle", {0.1F, 0.3F});
    file.point(kLight + "/spot/outerConeAngle", {0.5F, 0.7F});
    const SpotLight lamp = halfway(file).spotLights.at(0);
    EXPECT_EQ(lamp.intensityCandela, 200.0);
    EXPECT_EQ(lamp.color, glm::vec3(0.5F, 0.0F, 0.5F));
    EXPECT_EQ(lamp.rangeMetres, 20.0);
    EXPECT_NEAR(lamp.innerConeAngle, 0.2, 1e-7);
    EXPECT_NEAR(lamp.outerConeAngle, 0.6, 1e-7);
}

TEST(PointerTest, PointLightsAndSuns) {
    PointedFile file;
    file.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}},
                                                                {{"type", "directional"}}};
    file.addLampNode(1);
    file.point("/extensions/KHR_lights_punctual/lights/0/intensity", {1, 3});
    file.point("/extensions/KHR_lights_punctual/lights/1/intensity", {10, 30});
    file.point("/extensions/KHR_lights_punctual/lights/1/color", {0, 0, 0, 1, 1, 1});
    const Scene scene = halfway(file);
    EXPECT_EQ(scene.pointLights.at(0).intensityCandela, 2.0);
    EXPECT_EQ(scene.directionalLights.at(0).illuminanceLux, 20.0);
    EXPECT_EQ(scene.directionalLights.at(0).color, glm::vec3(0.5F));
}

TEST(PointerTest, Cameras) {
    PointedFile file;
    file.point("/cameras/0/perspective/yfov", {0.4F, 0.8F});
    file.point("/cameras/0/perspective/aspectRatio", {1, 2});
    file.point("/cameras/0/perspective/znear", {1, 2});
    file.point("/cameras/0/perspective/zfar", {10, 20});
    file.point("/cameras/1/orthographic/xmag", {4, 6});
    file.point("/cameras/1/orthographic/ymag", {2, 4});
    file.point("/cameras/1/orthographic/znear", {2, 4});
    file.point("/cameras/1/orthographic/zfar", {20, 40});
    const Scene scene = halfway(file);
    const auto lens = std::get<PerspectiveLens>(scene.cameras.at(0).lens);
    EXPECT_NEAR(lens.verticalFov, 0.6, 1e-7);
    EXPECT_EQ(lens.aspectRatio, 1.5);
    EXPECT_EQ(scene.cameras[0].nearMetres, 1.5);
    EXPECT_EQ(scene.cameras[0].farMetres, 15.0);
    const auto box = std::get<OrthographicLens>(scene.cameras.at(1).lens);
    EXPECT_EQ(box, (OrthographicLens{5.0, 3.0}));
    EXPECT_EQ(scene.cameras[1].nearMetres, 3.0);
    EXPECT_EQ(scene.cameras[1].farMetres, 30.0);
    // One that was taken from the scene follows its own alone.
    Camera own = load(file).scene.cameras[0];
    own.nearMetres = 0.25;
    EXPECT_EQ(posedCamera(scene, own), scene.cameras[0]);
    own.node = -1;
    EXPECT_EQ(posedCamera(scene, own), own);
}

TEST(PointerTest, Materials) {
    PointedFile file;
    file.json["materials"][0].update(
        {{"emissiveFactor", {1, 0.5, 0}},
         {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 10}}}}}});
    file.point("/materials/0/pbrMetallicRoughness/baseColorFactor", {0, 0, 0, 1, 1, 1, 1, 0});
    const std::string strength = "/extensions/KHR_materials_emissive_strength/emissiveStrength";
    file.point("/materials/0" + strength, {20, 40});
    const LoadedScene loaded = load(file);
    EXPECT_EQ(reportText(loaded), "");
    Scene scene = posed(loaded, 1.0);
    EXPECT_EQ(scene.materials.at(0).baseColor, glm::vec4(0.5F));
    // The factor rests, the strength moves.
    EXPECT_EQ(scene.materials[0].emission, glm::vec3(30.0F, 15.0F, 0.0F));
    restScene(scene);
    EXPECT_EQ(scene.materials[0].baseColor, glm::vec4(1.0F));
    EXPECT_EQ(scene.materials[0].emission, glm::vec3(10.0F, 5.0F, 0.0F));
}

TEST(PointerTest, NodesMoveAsByPlainChannels) {
    PointedFile pointed;
    PointedFile plain;
    const float half = std::sqrt(0.5F);
    const std::pair<const char*, std::vector<float>> moves[] = {
        {"translation", {0, 0, 0, 4, 2, 1}},
        {"rotation", {0, 0, 0, 1, 0, half, 0, half}},
        {"scale", {1, 1, 1, 3, 3, 3}},
    };
    for (const auto& [path, numbers] : moves) {
        pointed.point("/nodes/0/" + std::string(path), numbers);
        const int sampler = plain.addSampler(plain.addFloats(numbers));
        plain.animation()["channels"].push_back(
            {{"sampler", sampler}, {"target", {{"node", 0}, {"path", path}}}});
    }
    const Scene scene = halfway(pointed);
    EXPECT_EQ(scene.nodes.at(0).worldFromLocal, halfway(plain).nodes.at(0).worldFromLocal);
    EXPECT_EQ(scene.movers.size(), 1U);
    // A plain channel and a pointer may not have the same part.
    pointed.animation()["channels"].push_back(plain.animation()["channels"][0]);
    const LoadedScene twice = load(pointed);
    EXPECT_EQ(channelsOf(twice), 3U);
    expectLine(twice, Report::Kind::kIgnored, "/animations/0/channels/3/target", "already");
}

TEST(PointerTest, WeightsOfMorphTargets) {
    PointedFile file;
    file.json["meshes"][0]["primitives"][0]["targets"] = {
        {{"POSITION", file.addPositions({1, 0, 0, 1, 0, 0, 1, 0, 0})}}};
    file.point("/nodes/0/weights", {0, 1});
    EXPECT_EQ(halfway(file).deformers.at(0).weights, std::vector<float>{0.5F});
    PointedFile none;
    none.point("/nodes/0/weights", {0, 1});
    expectLeftOut(none, kAim, "without morph targets");
}

TEST(PointerTest, NodesAreShownAndHidden) {
    PointedFile file;
    file.json["nodes"][0]["children"] = {1};
    file.json["scenes"][0]["nodes"] = {0, 2, 3};
    file.json["nodes"][0]["extensions"]["KHR_node_visibility"]["visible"] = false;
    const int output = file.addAccessor(std::vector<std::uint8_t>{1, 0, 0, 0}, "SCALAR", kByte, 2);
    file.point("/nodes/0/extensions/KHR_node_visibility/visible", file.addSampler(output, "STEP"));
    const LoadedScene loaded = load(file);
    EXPECT_EQ(reportText(loaded), "");
    EXPECT_FALSE(loaded.scene.nodes.at(0).isDrawn());
    Scene scene = posed(loaded, 1.99);
    EXPECT_TRUE(scene.nodes[0].isDrawn());
    EXPECT_TRUE(scene.spotLights.at(0).shown) << "it hangs on that node";
    poseScene(scene, 2.0);
    EXPECT_FALSE(scene.nodes[0].isDrawn());
    EXPECT_FALSE(scene.spotLights[0].shown);
    poseScene(scene, 0.5);
    restScene(scene);
    EXPECT_FALSE(scene.nodes[0].isDrawn());
}

TEST(PointerTest, SwitchesAreStepped) {
    PointedFile file;
    const std::string visible = "/nodes/0/extensions/KHR_node_visibility/visible";
    file.point(visible, {0, 1});
    const LoadedScene loaded = load(file);
    expectLine(loaded, Report::Kind::kRepaired, "/animations/0/samplers/0/interpolation", "STEP");
    expectLine(loaded, Report::Kind::kHint, "/accessors/1", "unsigned bytes");
    EXPECT_FALSE(posed(loaded, 1.9).nodes.at(0).visible);
    EXPECT_TRUE(posed(loaded, 2.0).nodes.at(0).visible);
    PointedFile curved;
    curved.point(visible, {0, 0, 0, 0, 1, 0}, "CUBICSPLINE");
    expectLeftOut(curved, "/animations/0/samplers/0/interpolation", "CUBICSPLINE");
}

TEST(PointerTest, LightsAndCamerasOfSeveralNodes) {
    PointedFile file;
    file.addLampNode(0);
    file.addNode({{"camera", 0}});
    file.point(kLight + "/intensity", {100, 300});
    file.point("/cameras/0/perspective/yfov", {0.4F, 0.8F});
    const Scene scene = halfway(file);
    ASSERT_EQ(scene.spotLights.size(), 2U);
    for (const SpotLight& lamp : scene.spotLights) {
        EXPECT_EQ(lamp.intensityCandela, 200.0);
    }
    EXPECT_EQ(scene.cameras.at(0).lens, scene.cameras.at(2).lens);
    EXPECT_EQ(scene.dials.size(), 2U);
}

TEST(PointerTest, RestIsToTheLastBitWhatItWas) {
    PointedFile file;
    file.json["extensions"]["KHR_lights_punctual"]["lights"][0].update(
        {{"color", {0.1, 0.2, 0.3}}, {"intensity", 1234.56789}});
    file.json["cameras"][0]["perspective"].erase("zfar");
    for (const char* name : {"/intensity", "/spot/outerConeAngle", "/range"}) {
        file.point(kLight + name, {0.5F, 0.7F});
    }
    file.point(kLight + "/color", {0, 0, 0, 1, 1, 1});
    file.point("/cameras/0/perspective/znear", {1, 2});
    file.point("/cameras/0/perspective/yfov", {1, 2});
    file.point("/cameras/1/orthographic/xmag", {1, 2});
    const LoadedScene loaded = load(file);
    Scene scene = posed(loaded, 0.7);
    EXPECT_NE(scene.spotLights, loaded.scene.spotLights);
    restScene(scene);
    EXPECT_EQ(scene.spotLights, loaded.scene.spotLights);
    EXPECT_EQ(scene.cameras, loaded.scene.cameras);
    EXPECT_TRUE(std::isinf(scene.cameras[0].farMetres));
}

TEST(PointerTest, SplinesAreKeptWithinWhatCanBeDrawn) {
    // From 100 cd to 100 cd with a slope that would take it to 100 - 0.5 * 1000 = -400 cd halfway.
    PointedFile file;
    file.point(kLight + "/intensity", {0, 100, -1000, 1000, 100, 0}, "CUBICSPLINE");
    const LoadedScene loaded = load(file);
    EXPECT_EQ(reportText(loaded), "");
    EXPECT_EQ(posed(loaded, 1.0).spotLights.at(0).intensityCandela, 0.0);
    // 0.01 of the way: 100 + 2 * (-1000) * (0.01 - 2e-4 + 1e-6) + 2 * 1000 * (1e-6 - 1e-4).
    EXPECT_NEAR(posed(loaded, 0.02).spotLights[0].intensityCandela, 80.2, 1e-4);
}

TEST(PointerTest, KeysOutOfRangeAreMended) {
    const struct {
        std::string pointer;
        std::vector<float> numbers;
        const char* word;
    } faults[] = {
        {kLight + "/intensity", {-5, -7}, "such as -5; the nearest that can is played, there 0"},
        {kLight + "/color", {1, 1, -1, 1, 1, 1}, "1 key a value"},
        {kLight + "/range", {0, -1}, "there inf"},
        {kLight + "/spot/outerConeAngle", {1.57F, 3}, "there 1.396"},
        {kLight + "/spot/innerConeAngle", {-1, 0}, "there 0"},
        {"/cameras/0/perspective/yfov", {0, 4}, "2 keys"},
        {"/cameras/0/perspective/znear", {0, 0}, "there 1e-09"},
        {"/cameras/1/orthographic/xmag", {-3, 0}, "there 3"},
        {"/materials/0/emissiveFactor", {2, 0, 0, 0, 0, 0}, "there 1"},
    };
    for (const auto& fault : faults) {
        PointedFile file;
        file.point(fault.pointer, fault.numbers);
        const LoadedScene loaded = load(file);  // which looks at poses, too
        EXPECT_EQ(channelsOf(loaded), 1U) << fault.pointer;
        expectLine(loaded, Report::Kind::kRepaired, "/accessors/1", fault.word);
    }
}

TEST(PointerTest, InnerConesStayWithinOuterOnes) {
    PointedFile file;
    file.point(kLight + "/spot/outerConeAngle", {0.1F, 0.6F});
    const LoadedScene loaded = load(file);
    expectLine(loaded, Report::Kind::kHint, kAim, "hard edge");
    const SpotLight narrow = posed(loaded, 0.0).spotLights.at(0);
    EXPECT_EQ(narrow.innerConeAngle, narrow.outerConeAngle);
    EXPECT_EQ(posed(loaded, 2.0).spotLights.at(0).innerConeAngle, 0.2);
}

TEST(PointerTest, FarPlanesStayBeyondNearOnes) {
    PointedFile file;
    file.point("/cameras/0/perspective/znear", {1, 200});
    file.point("/cameras/1/orthographic/zfar", {0, 20});
    const LoadedScene loaded = load(file);
    expectLine(loaded, Report::Kind::kHint, kAim, "near plane");
    EXPECT_TRUE(std::isinf(posed(loaded, 2.0).cameras.at(0).farMetres));
    EXPECT_EQ(posed(loaded, 0.0).cameras.at(1).farMetres, 101.0);
}

TEST(PointerTest, IntegersCountAsTheyAre) {
    PointedFile file;
    file.point(
        kLight + "/intensity",
        file.addSampler(file.addAccessor(std::vector<std::uint16_t>{100, 300}, "SCALAR", 5123, 2)));
    EXPECT_EQ(halfway(file).spotLights.at(0).intensityCandela, 200.0);
    PointedFile normalized;
    const int output = normalized.addAccessor(
        std::vector<std::uint8_t>{0, 0, 0, 0, 255, 255, 255, 0}, "VEC3", kByte, 2);
    normalized.json["accessors"][std::size_t(output)]["normalized"] = true;
    normalized.json["bufferViews"].back()["byteStride"] = 4;
    normalized.point(kLight + "/color", normalized.addSampler(output));
    EXPECT_EQ(posed(load(normalized), 1.0).spotLights.at(0).color, glm::vec3(0.5F));
}

TEST(PointerTest, UnitsAreScaledAsAsked) {
    PointedFile file;
    file.point(kLight + "/intensity", {100, 300});
    file.point(kLight + "/range", {1000, 3000});
    file.point("/cameras/0/perspective/znear", {10, 30});
    file.point("/cameras/0/perspective/yfov", {0.5F, 0.7F});
    file.point("/cameras/1/orthographic/xmag", {100, 300});
    file.point("/nodes/0/translation", {0, 0, 0, 200, 0, 0});
    const TestFolder folder;
    LoadOptions options;
    options.unitScale = 0.01;
    options.intensityScale = 683.0;
    LoadedScene loaded = loadGltf(file.writeTo(folder), options);
    const std::vector<SpotLight> rest = loaded.scene.spotLights;
    EXPECT_EQ(rest.at(0).intensityCandela, 683000.0);
    poseScene(loaded.scene, 1.0);
    EXPECT_NEAR(loaded.scene.spotLights.at(0).intensityCandela, 200.0 * 683.0, 1e-9);
    EXPECT_NEAR(loaded.scene.spotLights[0].rangeMetres, 20.0, 1e-12);
    EXPECT_NEAR(loaded.scene.cameras.at(0).nearMetres, 0.2, 1e-12);
    EXPECT_NEAR(loaded.scene.cameras[0].farMetres, 1.0, 1e-12);
    EXPECT_NEAR(std::get<PerspectiveLens>(loaded.scene.cameras[0].lens).verticalFov, 0.6, 1e-7);
    const auto box = std::get<OrthographicLens>(loaded.scene.cameras.at(1).lens);
    EXPECT_NEAR(box.halfWidth, 2.0, 1e-12);
    EXPECT_NEAR(box.halfHeight, 0.01, 1e-12);
    EXPECT_NEAR(loaded.scene.nodes.at(0).worldFromLocal[3].x, 1.0, 1e-12);
    restScene(loaded.scene);
    EXPECT_EQ(loaded.scene.spotLights, rest);
}

TEST(PointerTest, WhatIsNotAnimatedIsNamedAndTheRestPlays) {
    PointedFile file;
    for (const int material : {0, 0, 1}) {
        file.point("/materials/" + std::to_string(material) + "/normalTexture/scale", {0, 1});
    }
    file.point(kLight + "/intensity", {100, 300});
    const LoadedScene loaded = load(file);
    EXPECT_EQ(channelsOf(loaded), 1U);
    expectLine(loaded, Report::Kind::kIgnored, kAim,
               "is \"/materials/{}/normalTexture/scale\", which is not animated here; the channel "
               "is left out (3 places");
    EXPECT_EQ(posed(loaded, 1.0).spotLights.at(0).intensityCandela, 200.0);
}

TEST(PointerTest, PointersToNothing) {
    const struct {
        std::string pointer;
        const char* word;
    } faults[] = {
        {"/extensions/KHR_lights_punctual/lights/1/intensity", "1 light,"},
        {"/cameras/2/perspective/yfov", "2 cameras"},
        {"/nodes/9/translation", "4 nodes"},
        {"/materials/7/emissiveFactor", "1 material"},
        {"/cameras/0/orthographic/xmag", "is perspective"},
        {"/cameras/1/perspective/yfov", "is orthographic"},
        {"/nodes/01/scale", "not animated"},
        {"/nodes//scale", "not animated"},
        {"/nodes/-1/scale", "not animated"},
        {"/nodes/99999999999999999999/scale", "not animated"},
        {"/nodes/0/scale/", "not animated"},
        {"nodes/0/scale", "starts with /"},
        {"", "starts with /"},
        {"/" + std::string(5000, 'x'), "xxx...\""},
    };
    for (const auto& fault : faults) {
        PointedFile file;
        file.point(fault.pointer, {1, 2});
        expectLeftOut(file, kAim, fault.word);
    }
}

TEST(PointerTest, LightsThatHaveNoSuchThing) {
    const auto fileWith = [](const json& light, const std::string& property) {
        PointedFile file;
        file.json["extensions"]["KHR_lights_punctual"]["lights"][0] = light;
        file.point(kLight + property, {1, 2});
        return file;
    };
    expectLeftOut(fileWith({{"type", "point"}}, "/spot/outerConeAngle"), kAim, "no spot");
    expectLeftOut(fileWith({{"type", "directional"}}, "/range"), kAim, "no range");
    expectLeftOut(fileWith({{"type", "lamp"}}, "/intensity"), kAim, "cannot be read");
    expectLine(load(fileWith({{"type", "point"}}, "/range")), Report::Kind::kHint, kAim,
               "no default");
}

TEST(PointerTest, WhatTheDrawnSceneDoesNotUse) {
    PointedFile file;
    file.json["extensions"]["KHR_lights_punctual"]["lights"].push_back({{"type", "point"}});
    file.point("/extensions/KHR_lights_punctual/lights/1/intensity", {1, 2});
    expectLeftOut(file, kAim, "nothing in the drawn scene");
    PointedFile elsewhere;
    elsewhere.push("nodes", {{"name", "of no scene"}});
    elsewhere.point("/nodes/4/extensions/KHR_node_visibility/visible", {1, 0});
    expectLeftOut(elsewhere, kAim, "another scene");
    PointedFile glossy;
    glossy.json["materials"][0]["extensions"]["KHR_materials_pbrSpecularGlossiness"] =
        json::object();
    glossy.point("/materials/0/pbrMetallicRoughness/baseColorFactor", {0, 0, 0, 1, 1, 1, 1, 1});
    expectLeftOut(glossy, kAim, "pbrSpecularGlossiness");
}

TEST(PointerTest, BrokenChannels) {
    PointedFile types;
    types.point(kLight + "/color", {1, 2});
    expectLeftOut(types, "/accessors/1/type", "VEC3");
    PointedFile counts;
    counts.point(kLight + "/intensity", counts.addSampler(counts.addFloats({1, 2, 3}, 3)));
    expectLeftOut(counts, "/accessors/1/count", "one for each of the 2 keys");
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        PointedFile infinite;
        infinite.point(kLight + "/intensity", {1, bad});
        expectLeftOut(infinite, "/accessors/1", "not finite at element 1");
    }
    PointedFile none;
    none.point("", {1, 2});
    none.animation()["channels"][0]["target"].erase("extensions");
    expectLeftOut(none, "/animations/0/channels/0/target/path", "the target has none");
    PointedFile both;
    both.point(kLight + "/intensity", {100, 300});
    both.animation()["channels"][0]["target"]["node"] = 0;
    const LoadedScene loaded = load(both);
    EXPECT_EQ(channelsOf(loaded), 1U);
    expectLine(loaded, Report::Kind::kHint, "/animations/0/channels/0/target/node", "followed");
}

TEST(PointerTest, TwoOfOneAreLeftOutAndTwoOfAConeAreNot) {
    PointedFile file;
    file.point(kLight + "/spot/innerConeAngle", {0.1F, 0.2F});
    file.point(kLight + "/spot/outerConeAngle", {0.3F, 0.4F});
    file.point(kLight + "/spot/innerConeAngle", {0.0F, 0.0F});
    const LoadedScene loaded = load(file);
    EXPECT_EQ(channelsOf(loaded), 2U);
    EXPECT_EQ(loaded.scene.dials.size(), 1U);
    expectLine(loaded, Report::Kind::kIgnored, "/animations/0/channels/2/target", "already");
}

TEST(PointerTest, LightProfilesAreDrawnInThePlaceOfLights) {
    // A lamp with a measured profile does not follow the light that it takes the place of.
    PointedFile file;
    file.json["extensions"]["EXT_lights_ies"]["lights"] = {
        {{"uri",
          "data:,IESNA:LM-63-2002%0ATILT=NONE%0A1 100 1 3 1 1 2 0 0 0%0A1 1 10%0A0 45 90%0A"
          "0%0A100 100 100%0A"}}};
    file.json["nodes"][1]["extensions"]["EXT_lights_ies"]["light"] = 0;
    file.point(kLight + "/intensity", {100, 300});
    const LoadedScene loaded = load(file);
    ASSERT_EQ(loaded.scene.spotLights.size(), 1U);
    ASSERT_TRUE(loaded.scene.spotLights[0].lightMap.has_value());
    EXPECT_EQ(channelsOf(loaded), 0U);
    expectLine(loaded, Report::Kind::kIgnored, kAim, "nothing in the drawn scene");
}

TEST(PointerTest, NamesOfManyAreOne) {
    EXPECT_EQ(gltf::withoutIndices("/materials/12/a1/3"), "/materials/{}/a1/{}");
    EXPECT_EQ(gltf::withoutIndices("/1a/2"), "/1a/{}");
    EXPECT_EQ(gltf::withoutIndices("12"), "12");
}

}  // namespace
}  // namespace ribalta::test
