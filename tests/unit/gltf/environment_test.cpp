// EXT_lights_image_based: the light around a scene, and what is said of one that cannot be drawn.
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "gltf_file.h"

namespace ribalta::test {
namespace {

using nlohmann::json;

const std::string kUse = "/scenes/0/extensions/EXT_lights_image_based/light";
const std::string kLight = "/extensions/EXT_lights_image_based/lights/0";

json coefficients(double first = 0.0) {
    json list = json::array();
    for (int i = 0; i < 9; ++i) {
        list.push_back({i == 0 ? first : 0.0, 0.0, 0.0});
    }
    return list;
}

// A triangle under one light, which has no pictures.
GltfFile fileWithEnvironment(const json& light, const json& use = 0) {
    GltfFile file = triangleFile();
    file.json["extensions"]["EXT_lights_image_based"]["lights"] = {light};
    file.json["scenes"][0]["extensions"]["EXT_lights_image_based"]["light"] = use;
    return file;
}

json evenLight(double lux) {
    return {{"irradianceCoefficients", coefficients(lux * std::sqrt(4.0 * std::numbers::pi))},
            {"specularImages", json::array()},
            {"specularImageSize", 4}};
}

glm::dvec3 luxOn(const LoadedScene& loaded, const glm::dvec3& normal) {
    return loaded.scene.environment ? irradiance(*loaded.scene.environment, normal)
                                    : glm::dvec3(-1.0);
}

TEST(GltfEnvironmentTest, LightOfTheScene) {
    json light = evenLight(100.0);
    light["name"] = "hall";
    light["intensity"] = 2.0;
    const LoadedScene loaded = load(fileWithEnvironment(light));
    ASSERT_TRUE(loaded.scene.environment);
    EXPECT_EQ(loaded.scene.environment->name, "hall");
    EXPECT_NEAR(luxOn(loaded, {0, 1, 0}).x, 200.0, 1e-9);
    EXPECT_EQ(luxOn(loaded, {0, 1, 0}).y, 0.0);
    expectLine(loaded, Report::Kind::kIgnored, kLight + "/specularImages", "are not drawn");
    // Without a light there is none, whatever the file holds.
    GltfFile without = fileWithEnvironment(light);
    without.json["scenes"][0].erase("extensions");
    EXPECT_FALSE(load(without).scene.environment);
}

TEST(GltfEnvironmentTest, OrderAndRotation) {
    // Of y, z and x, each in a colour of its own.
    json light = evenLight(0.0);
    const double one = 1.0 / std::sqrt(3.0 / (4.0 * std::numbers::pi));
    light["irradianceCoefficients"][1] = {one, 0, 0};
    light["irradianceCoefficients"][2] = {0, one, 0};
    light["irradianceCoefficients"][3] = {0, 0, one};
    const LoadedScene plain = load(fileWithEnvironment(light));
    EXPECT_NEAR(luxOn(plain, {0, 1, 0}).x, 1.0, 1e-12);
    EXPECT_NEAR(luxOn(plain, {0, 0, 1}).y, 1.0, 1e-12);
    EXPECT_NEAR(luxOn(plain, {1, 0, 0}).z, 1.0, 1e-12);
    EXPECT_EQ(luxOn(plain, {0, -1, 0}), glm::dvec3(0.0));
    // A quarter of a turn about x, of twice the length that it should have: y goes to z.
    light["rotation"] = {std::sqrt(2.0), 0, 0, std::sqrt(2.0)};
    const LoadedScene turned = load(fileWithEnvironment(light));
    expectLine(turned, Report::Kind::kRepaired, kLight + "/rotation", "length 2");
    EXPECT_NEAR(luxOn(turned, {0, 0, 1}).x, 1.0, 1e-12);
    EXPECT_NEAR(luxOn(turned, {0, -1, 0}).y, 1.0, 1e-12);
}

TEST(GltfEnvironmentTest, UnitsAreScaledAsAsked) {
    const TestFolder folder;
    LoadOptions options;
    options.intensityScale = 683.0;
    const LoadedScene loaded =
        loadGltf(fileWithEnvironment(evenLight(2.0)).writeTo(folder), options);
    EXPECT_NEAR(luxOn(loaded, {0, 0, 1}).x, 1366.0, 1e-9);
}

TEST(GltfEnvironmentTest, LightsThatCannotBeDrawnAreLeftOut) {
    const auto expectNone = [](const GltfFile& file, const std::string& place,
                               const std::string& word) {
        const LoadedScene loaded = load(file);
        EXPECT_FALSE(loaded.scene.environment) << place;
        expectLine(loaded, Report::Kind::kIgnored, place, word);
    };
    for (const json& use : {json(1), json(-1), json("x"), json(nullptr), json(0.5)}) {
        expectNone(fileWithEnvironment(evenLight(1.0), use), kUse, "1 image-based light;");
    }
    GltfFile none = fileWithEnvironment(evenLight(1.0));
    none.json["extensions"]["EXT_lights_image_based"]["lights"] = 5;
    expectNone(none, kUse, "0 image-based lights");
    const auto changed = [](const json& value) {
        json light = evenLight(1.0);
        light["irradianceCoefficients"] = value;
        return fileWithEnvironment(light);
    };
    const std::string here = kLight + "/irradianceCoefficients";
    json few = coefficients();
    few.erase(8);
    expectNone(changed(few), here, "8 coefficients, expected nine");
    expectNone(changed(5), here, "is no list");
    json flat = coefficients();
    flat[3] = 1.0;
    expectNone(changed(flat), here + "/3", "three finite numbers");
    json wide = coefficients();
    wide[0] = {1, 2, 3, 4};
    expectNone(changed(wide), here + "/0", "three finite numbers");
    json huge = coefficients();
    huge[2] = {0, 1e300, 0};
    expectNone(changed(huge), here + "/2", "three finite numbers");
    json missing = evenLight(1.0);
    missing.erase("irradianceCoefficients");
    expectNone(fileWithEnvironment(missing), here, "is missing");
    expectNone(fileWithEnvironment(json(7)), here, "is missing");
}

TEST(GltfEnvironmentTest, WhatCanBeMendedIs) {
    const auto mended = [](const char* key, const json& value, const std::string& word) {
        json light = evenLight(3.0);
        light[key] = value;
        const LoadedScene loaded = load(fileWithEnvironment(light));
        EXPECT_NEAR(luxOn(loaded, {0, 1, 0}).x, 3.0, 1e-9) << key;
        expectLine(loaded, Report::Kind::kRepaired, kLight + "/" + key, word);
    };
    mended("rotation", {0, 0, 0, 0}, "no rotation");
    mended("rotation", {0, 0, 1}, "no rotation");
    mended("rotation", "x", "no rotation");
    mended("intensity", -1, "is -1");
    mended("intensity", "x", "1 is used");
    json bright = evenLight(1e11);
    bright["intensity"] = 1e11;
    EXPECT_TRUE(std::isfinite(luxOn(load(fileWithEnvironment(bright)), {0, 1, 0}).x));
}

TEST(GltfEnvironmentTest, PicturesThatAreNotThereAreNamed) {
    json light = evenLight(1.0);
    light["specularImages"] = {{0, 1, 2, 3, 4, 9}};
    GltfFile file = fileWithEnvironment(light);
    const LoadedScene loaded = load(file);
    EXPECT_TRUE(loaded.scene.environment);
    expectLine(loaded, Report::Kind::kHint, kLight + "/specularImages/0/0", "0 images");
    light["specularImages"] = {{0, 1}};
    expectLine(load(fileWithEnvironment(light)), Report::Kind::kHint, kLight + "/specularImages/0",
               "faces of a cube");
    light.erase("specularImages");
    expectLine(load(fileWithEnvironment(light)), Report::Kind::kHint, kLight + "/specularImages",
               "missing");
}

}  // namespace
}  // namespace ribalta::test
