// Lamps and the light maps of their custom properties.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "gltf_file.h"
#include "support/make_png.h"

namespace ribalta::test {
namespace {

using nlohmann::json;

constexpr const char* kLights = "/extensions/KHR_lights_punctual/lights";

std::vector<std::byte> somePng() {
    return makePng({.width = 1, .height = 1, .rows = {std::string("\xff\x00\x00\xff", 4)}});
}

// A triangle and a lamp on a node that has more members.
GltfFile fileWithLamp(const json& light, const json& node = json::object()) {
    GltfFile file = triangleFile();
    file.json["extensionsUsed"] = {"KHR_lights_punctual"};
    json& lights = file.json["extensions"]["KHR_lights_punctual"]["lights"];
    lights.push_back(light);
    json whole = node;
    whole["extensions"]["KHR_lights_punctual"]["light"] = lights.size() - 1;
    file.addNode(whole);
    return file;
}

json spotLight(const json& extras = nullptr) {
    json light = {{"type", "spot"},
                  {"intensity", 1000},
                  {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.3}}}};
    if (!extras.is_null()) {
        light["extras"] = extras;
    }
    return light;
}

SpotLight spotOf(const GltfFile& file) {
    return load(file).scene.spotLights.at(0);
}

TEST(LampTest, SpotPointAndDirectional) {
    json spot = spotLight();
    spot.update({{"color", {1, 0.5, 0.25}}, {"range", 12}});
    const SpotLight lamp = spotOf(fileWithLamp(spot, {{"translation", {0, 5, 0}}}));
    EXPECT_EQ(lamp.color, glm::vec3(1.0F, 0.5F, 0.25F));
    EXPECT_EQ(lamp.intensityCandela, 1000.0);
    EXPECT_EQ(lamp.innerConeAngle, 0.2);
    EXPECT_EQ(lamp.outerConeAngle, 0.3);
    EXPECT_EQ(lamp.rangeMetres, 12.0);
    EXPECT_EQ(lamp.frame.position, glm::dvec3(0.0, 5.0, 0.0));
    EXPECT_FALSE(lamp.lightMap);
    EXPECT_EQ(lamp.beamShape, BeamShape::kCone);

    const LoadedScene point = load(fileWithLamp({{"type", "point"}}, {{"translation", {1, 2, 3}}}));
    ASSERT_EQ(point.scene.pointLights.size(), 1U);
    EXPECT_EQ(point.scene.pointLights[0].position, glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_EQ(point.scene.pointLights[0].color, glm::vec3(1.0F));
    EXPECT_EQ(point.scene.pointLights[0].intensityCandela, 1.0);
    EXPECT_TRUE(std::isinf(point.scene.pointLights[0].rangeMetres));

    const LoadedScene sun = load(fileWithLamp({{"type", "directional"}, {"intensity", 100000}}));
    ASSERT_EQ(sun.scene.directionalLights.size(), 1U);
    EXPECT_EQ(sun.scene.directionalLights[0].direction, glm::dvec3(0.0, 0.0, -1.0));
    EXPECT_EQ(sun.scene.directionalLights[0].illuminanceLux, 100000.0);
}

TEST(LampTest, OneLightOnSeveralNodesIsALampEach) {
    GltfFile file = fileWithLamp(spotLight(), {{"name", "left"}});
    file.addNode({{"name", "right"},
                  {"translation", {4, 0, 0}},
                  {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    const LoadedScene loaded = load(file);
    ASSERT_EQ(loaded.scene.spotLights.size(), 2U);
    EXPECT_EQ(loaded.scene.spotLights[0].name, "left");
    EXPECT_EQ(loaded.scene.spotLights[1].name, "right");
    EXPECT_EQ(loaded.scene.spotLights[1].frame.position.x, 4.0);
}

TEST(LampTest, NamesOfNodeThenLightThenNumber) {
    json named = spotLight();
    named["name"] = "profile";
    EXPECT_EQ(spotOf(fileWithLamp(named, {{"name", "spot left"}})).name, "spot left");
    EXPECT_EQ(spotOf(fileWithLamp(named)).name, "profile");
    EXPECT_EQ(spotOf(fileWithLamp(spotLight())).name, "spot_0");
}

TEST(LampTest, LightMapOnTheLightBeforeTheNode) {
    const TestFolder folder;
    folder.write("a.png", somePng());
    folder.write("b.png", somePng());
    struct Case {
        json lightExtras;
        json nodeExtras;
        std::string expected;
    };
    const Case cases[] = {
        {{{"light_map", "a.png"}}, {{"light_map", "b.png"}}, "a.png"},
        {{{"gobo", "a.png"}}, {{"light_map", "b.png"}}, "a.png"},
        {{{"gobo", "b.png"}, {"light_map", "a.png"}}, nullptr, "a.png"},
        {nullptr, {{"light_map", "b.png"}}, "b.png"},
        {nullptr, {{"gobo", "b.png"}}, "b.png"},
    };
    for (const Case& c : cases) {
        json node = json::object();
        if (!c.nodeExtras.is_null()) {
            node["extras"] = c.nodeExtras;
        }
        const LoadedScene loaded =
            load(fileWithLamp(spotLight(c.lightExtras), node).writeTo(folder));
        const SpotLight& spot = loaded.scene.spotLights.at(0);
        ASSERT_TRUE(spot.lightMap);
        EXPECT_EQ(loaded.scene.images.at(std::size_t(spot.lightMap->image)).name, c.expected);
        EXPECT_EQ(loaded.scene.images.size(), 1U);
    }
}

TEST(LampTest, RotationAndShape) {
    const TestFolder folder;
    folder.write("a.png", somePng());
    const json extras = {
        {"light_map", "a.png"}, {"light_map_rotation", 90}, {"beam_shape", "pyramid"}};
    const LoadedScene loaded = load(fileWithLamp(spotLight(extras)).writeTo(folder));
    const SpotLight& spot = loaded.scene.spotLights.at(0);
    EXPECT_NEAR(spot.lightMap->rotationRadians, std::numbers::pi / 2, 1e-12);
    EXPECT_EQ(spot.beamShape, BeamShape::kPyramid);
    EXPECT_EQ(reportText(loaded), "");
}

TEST(LampTest, LightMapFromATexture) {
    GltfFile file = fileWithLamp(spotLight({{"light_map", {{"texture", 0}}}}));
    file.push("textures", {{"source", 0}});
    file.push("images", {{"uri", "data:;base64," + base64(somePng())}});
    const LoadedScene loaded = load(file);
    ASSERT_TRUE(loaded.scene.spotLights.at(0).lightMap);
    EXPECT_EQ(loaded.scene.images.size(), 1U);
    EXPECT_EQ(loaded.scene.images[0].width, 1);
    EXPECT_TRUE(loaded.scene.textures.empty());
}

TEST(LampTest, SharedLightMapIsDecodedOnce) {
    const TestFolder folder;
    folder.write("a.png", somePng());
    GltfFile file = fileWithLamp(spotLight({{"light_map", "a.png"}}));
    file.json["extensions"]["KHR_lights_punctual"]["lights"].push_back(
        spotLight({{"light_map", "./a.png"}}));
    file.addNode({{"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}});
    const LoadedScene loaded = load(file.writeTo(folder));
    EXPECT_EQ(loaded.scene.images.size(), 1U);
    EXPECT_EQ(loaded.scene.spotLights.at(1).lightMap->image, 0);
}

TEST(LampTest, LightMapThatCannotBeReadIsAStandIn) {
    for (const char* path : {"missing.png", "../a.png", "/a.png", "http://a/b.png"}) {
        const LoadedScene loaded = load(fileWithLamp(spotLight({{"light_map", path}})));
        ASSERT_TRUE(loaded.scene.spotLights.at(0).lightMap) << path;
        EXPECT_EQ(loaded.scene.images.at(0).pixels, makeStandInImage("").pixels);
        expectLine(loaded, Report::Kind::kRepaired, std::string(kLights) + "/0/extras/light_map",
                   path);
    }
}

TEST(LampTest, LightMapOfAnotherTypeIsTold) {
    for (const json& value :
         {json(7), json(""), json{{"texture", 3}}, json{{"texture", "a"}}, json::array()}) {
        const LoadedScene loaded = load(fileWithLamp(spotLight({{"gobo", value}})));
        EXPECT_FALSE(loaded.scene.spotLights.at(0).lightMap) << value;
        EXPECT_EQ(loaded.report.entries().size(), 1U) << reportText(loaded);
        EXPECT_EQ(loaded.report.entries().at(0).kind, Report::Kind::kIgnored);
    }
    const LoadedScene shape =
        load(fileWithLamp(spotLight({{"beam_shape", 3}, {"light_map_rotation", "much"}})));
    expectLine(shape, Report::Kind::kIgnored, std::string(kLights) + "/0/extras/beam_shape",
               "pyramid");
    expectLine(shape, Report::Kind::kIgnored, std::string(kLights) + "/0/extras/light_map_rotation",
               "degrees");
}

TEST(LampTest, LightMapOnOtherLampsIsTold) {
    for (const char* type : {"point", "directional"}) {
        const LoadedScene loaded =
            load(fileWithLamp({{"type", type}, {"extras", {{"light_map", "a.png"}}}}));
        expectLine(loaded, Report::Kind::kIgnored, std::string(kLights) + "/0/extras/light_map",
                   "spots only");
        EXPECT_TRUE(loaded.scene.images.empty());
    }
}

TEST(LampTest, ConesAreBroughtIntoWhatIsDrawn) {
    struct Case {
        double inner, outer, drawnInner, drawnOuter;
        const char* key;
    };
    const Case cases[] = {
        {0.0, 0.0, 0.0, kMinConeAngle, "outerConeAngle"},
        {0.1, 1.57, 0.1, kMaxConeAngle, "outerConeAngle"},
        {0.5, 0.5, 0.5, 0.5, "innerConeAngle"},
        {0.6, 0.5, 0.5, 0.5, "innerConeAngle"},
        {-0.1, 0.5, 0.0, 0.5, "innerConeAngle"},
        {0.1, 9.0, 0.1, kMaxConeAngle, "outerConeAngle"},
    };
    for (const Case& c : cases) {
        json light = spotLight();
        light["spot"] = {{"innerConeAngle", c.inner}, {"outerConeAngle", c.outer}};
        const LoadedScene loaded = load(fileWithLamp(light));
        const SpotLight& spot = loaded.scene.spotLights.at(0);
        EXPECT_EQ(spot.innerConeAngle, c.drawnInner) << c.inner << " " << c.outer;
        EXPECT_EQ(spot.outerConeAngle, c.drawnOuter) << c.inner << " " << c.outer;
        expectLine(loaded, Report::Kind::kRepaired, std::string(kLights) + "/0/spot/" + c.key,
                   "is ");
    }
}

TEST(LampTest, OtherValuesAreMended) {
    json light = spotLight();
    light.update({{"intensity", -5}, {"range", 0}, {"color", {1, 1}}});
    light.erase("spot");
    const LoadedScene loaded = load(fileWithLamp(light));
    const SpotLight& spot = loaded.scene.spotLights.at(0);
    EXPECT_EQ(spot.intensityCandela, 0.0);
    EXPECT_TRUE(std::isinf(spot.rangeMetres));
    EXPECT_EQ(spot.color, glm::vec3(1.0F));
    EXPECT_NEAR(spot.outerConeAngle, std::numbers::pi / 4, 1e-12);
    expectLine(loaded, Report::Kind::kRepaired, std::string(kLights) + "/0/intensity", "is -5");
    expectLine(loaded, Report::Kind::kRepaired, std::string(kLights) + "/0/range", "unlimited");
    expectLine(loaded, Report::Kind::kRepaired, std::string(kLights) + "/0/color", "2 numbers");
    expectLine(loaded, Report::Kind::kRepaired, std::string(kLights) + "/0", "without \"spot\"");
}

TEST(LampTest, FaultyLightCostsOnlyItsLamps) {
    for (const json& light :
         {json(nullptr), json("spot"), json{{"type", "laser"}}, json::object()}) {
        GltfFile file = fileWithLamp(spotLight());
        file.json["extensions"]["KHR_lights_punctual"]["lights"].push_back(light);
        file.addNode({{"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}});
        const LoadedScene loaded = load(file);
        EXPECT_EQ(loaded.scene.spotLights.size(), 1U);
        expectLine(loaded, Report::Kind::kIgnored, "/nodes/2/extensions/KHR_lights_punctual/light",
                   "light 1");
    }
    GltfFile file = fileWithLamp(spotLight());
    file.json["nodes"][1]["extensions"]["KHR_lights_punctual"]["light"] = 5;
    const LoadedScene loaded = load(file);
    EXPECT_TRUE(loaded.scene.spotLights.empty());
    expectLine(loaded, Report::Kind::kIgnored, "/nodes/1/extensions/KHR_lights_punctual/light",
               "the file has 1 light");
}

}  // namespace
}  // namespace ribalta::test
