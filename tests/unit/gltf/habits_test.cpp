// Artists' habits: paths of light maps as people type them, and files in other units.
#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "gltf_file.h"
#include "support/make_png.h"

namespace ribalta::test {
namespace {

using nlohmann::json;

// Spots with these intensities, ten metres apart times `spacing`, and a triangle.
GltfFile fileWithLamps(const std::vector<double>& candela, double spacing = 1.0,
                       const json& extras = nullptr) {
    GltfFile file = triangleFile();
    file.json["extensionsUsed"] = {"KHR_lights_punctual"};
    json& lights = file.json["extensions"]["KHR_lights_punctual"]["lights"];
    for (std::size_t i = 0; i < candela.size(); ++i) {
        json light = {
            {"type", "spot"}, {"intensity", candela[i]}, {"range", 7.0}, {"spot", json::object()}};
        if (!extras.is_null()) {
            light["extras"] = extras;
        }
        lights.push_back(light);
        file.addNode({{"translation", {10.0 * spacing * double(i), 5.0, 0.0}},
                      {"extensions", {{"KHR_lights_punctual", {{"light", i}}}}}});
    }
    return file;
}

TEST(HabitsTest, LightMapsAreFoundAsTheyAreMeant) {
    const TestFolder folder;
    std::filesystem::create_directories(folder.path() / "Gobos");
    const auto png = makePng({.rows = {std::string(4, '\x80')}});
    folder.write("Gobos/My Star.png", png);
    folder.write("window.png", png);
    const auto found = [&](const std::string& written, const std::string& word) {
        SCOPED_TRACE(written);
        const LoadedScene loaded =
            load(fileWithLamps({1000.0}, 1.0, {{"light_map", written}}).writeTo(folder));
        ASSERT_EQ(loaded.scene.images.size(), 1U);
        EXPECT_EQ(loaded.scene.images[0].width, 1) << reportText(loaded);
        if (word.empty()) {
            EXPECT_EQ(reportText(loaded), "");
        } else {
            expectLine(loaded, Report::Kind::kRepaired,
                       "/extensions/KHR_lights_punctual/lights/0/extras/light_map", word);
        }
    };
    found("Gobos/My Star.png", "");
    found(" Gobos/My Star.png ", "spaces");
    found("\"window.png\"", "quotes");
    found("Gobos\\My Star.png", "slashes");
    found("//Gobos/My Star.png", "Blender");
    found("//Gobos\\my%20star.PNG", "letters");
    found("Gobos/My%20Star.png", "%-codes");
    found("C:\\Users\\Someone\\Desktop\\window.png", "beside the scene");
    found("/home/someone/window.png", "beside the scene");
    found("file:///home/someone/WINDOW.png", "letters");
    found("gobos/MY STAR.png", "letters");
}

TEST(HabitsTest, TexturesOfUnreadKindsAreNamedWithACure) {
    GltfFile file = triangleFile();
    file.json["meshes"][0]["primitives"][0]["material"] = 0;
    file.push("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    file.push("textures", {{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}});
    file.push("images", {{"uri", "wood.ktx2"}});
    file.json["extensionsUsed"] = {"KHR_texture_basisu"};
    expectLine(load(file), Report::Kind::kIgnored,
               "/materials/0/pbrMetallicRoughness/baseColorTexture", "export it as PNG");
    file.json["extensionsRequired"] = {"KHR_texture_basisu"};
    expectRefused(file, "/extensionsRequired/0", {"KHR_texture_basisu", "PNG, JPEG or WebP"});
}

TEST(HabitsTest, NoWayLeadsOutOfTheFolder) {
    const TestFolder folder;
    std::filesystem::create_directories(folder.path() / "scene");
    folder.write("secret.png", makePng({.rows = {std::string(4, '\x80')}}));
    for (const std::string written : {"../secret.png", "..\\secret.png", "%2e%2e/secret.png",
                                      "//../secret.png", "../SECRET.png"}) {
        const GltfFile file = fileWithLamps({1000.0}, 1.0, {{"light_map", written}});
        const LoadedScene loaded = load(folder.write("scene/scene.gltf", file.text()));
        EXPECT_GT(loaded.scene.images.at(0).width, 1) << written;  // the checkerboard
    }
}

LoadedScene loadScaled(const GltfFile& file, double units, double intensity) {
    const TestFolder folder;
    LoadOptions options;
    options.unitScale = units;
    options.intensityScale = intensity;
    return loadGltf(file.writeTo(folder), options);
}

// A triangle with a picture on it, and its buffer in a file of its own.
GltfFile fileWithUris(const std::string& image, const std::string& buffer = "") {
    GltfFile file = triangleFile();
    file.json["images"] = {{{"uri", image}}};
    file.json["textures"] = {{{"source", 0}}};
    file.json["materials"] = {{{"emissiveTexture", {{"index", 0}}}}};
    file.json["meshes"][0]["primitives"][0]["material"] = 0;
    if (!buffer.empty()) {
        file.json["buffers"] = {{{"uri", buffer}, {"byteLength", file.bytes().size()}}};
    }
    return file;
}

bool isMended(const LoadedScene& loaded) {
    const auto& entries = loaded.report.entries();
    return std::any_of(entries.begin(), entries.end(), [](const Report::Entry& entry) {
        return entry.kind == Report::Kind::kRepaired;
    });
}

LoadedScene loadText(const TestFolder& folder, const GltfFile& file, const char* name) {
    return load(folder.write(name, file.json.dump()));
}

TEST(HabitsTest, PicturesAndBuffersAreFoundAsTheyAreMeant) {
    const TestFolder folder;
    std::filesystem::create_directories(folder.path() / "Textures");
    const auto png = makePng({.rows = {std::string(4, '\x80')}});
    for (const char* name : {"Textures/My Wood.png", "wood.png", "100%25.png"}) {
        folder.write(name, png);
        folder.write(std::filesystem::path(name).replace_extension("bin").string(),
                     triangleFile().bytes());
    }
    const struct {
        const char* stem;
        const char* word;  // of the report; empty: nothing is said
    } habits[] = {
        {"Textures/My%20Wood", ""},
        {"Textures/My Wood", ""},
        {"Textures\\My Wood", "slashes"},
        {".\\Textures\\My%20Wood", "slashes"},
        {"textures/my%20wood", "letters"},
        {"WOOD", "letters"},
        {"C:\\Users\\Someone\\wood", "beside the scene"},
        {"C:/Users/Someone/wood", "beside the scene"},
        {"/home/someone/wood", "beside the scene"},
        {"file:///C:/Users/Someone/wood", "beside the scene"},
        {"//wood", "Blender"},
        {" wood", "spaces"},
        {"100%25", "%-codes themselves"},
    };
    for (const auto& habit : habits) {
        SCOPED_TRACE(habit.stem);
        const std::string stem = habit.stem;
        const LoadedScene loaded =
            loadText(folder, fileWithUris(stem + ".png", stem + ".bin"), "scene.gltf");
        ASSERT_EQ(loaded.scene.images.size(), 1U);
        EXPECT_EQ(loaded.scene.images[0].width, 1) << reportText(loaded);
        EXPECT_EQ(onlyPrimitive(loaded).positions.size(), 3U);
        if (*habit.word == '\0') {
            EXPECT_FALSE(isMended(loaded)) << reportText(loaded);
        } else {
            expectLine(loaded, Report::Kind::kRepaired, "/images/0/uri", habit.word);
            expectLine(loaded, Report::Kind::kRepaired, "/buffers/0/uri", habit.word);
        }
    }
}

TEST(HabitsTest, NoUriLeadsOutOfTheFolder) {
    const TestFolder folder;
    std::filesystem::create_directories(folder.path() / "scene");
    folder.write("secret.png", makePng({.rows = {std::string(4, '\x80')}}));
    folder.write("secret.bin", triangleFile().bytes());
    for (const std::string stem : {"../secret", "..\\secret", "%2e%2e/secret", "//../secret",
                                   "../SECRET", "%2e%2e%5csecret", "https://example.com/secret"}) {
        const LoadedScene loaded =
            load(folder.write("scene/scene.gltf", fileWithUris(stem + ".png").text()));
        EXPECT_GT(loaded.scene.images.at(0).width, 1) << stem;  // the checkerboard
        expectRefused(
            folder.write("scene/buffer.gltf", fileWithUris("", stem + ".bin").json.dump()),
            "/buffers/0/uri", {});
    }
    // Where it is allowed, a path that is there needs no search.
    LoadOptions options;
    options.allowOutside = true;
    const LoadedScene allowed =
        loadGltf(folder.write("scene/scene.gltf", fileWithUris("../secret.png").text()), options);
    EXPECT_EQ(allowed.scene.images.at(0).width, 1);
    EXPECT_FALSE(isMended(allowed)) << reportText(allowed);
}

TEST(HabitsTest, OnePictureByTwoNamesIsReadOnce) {
    const TestFolder folder;
    folder.write("wood.png", makePng({.rows = {std::string(4, '\x80')}}));
    GltfFile file = fileWithUris("wood.png");
    file.json["images"].push_back({{"uri", "C:\\work\\Wood.PNG"}});
    file.json["textures"].push_back({{"source", 1}});
    file.json["materials"][0]["normalTexture"] = {{"index", 1}};
    const LoadedScene loaded = load(folder.write("scene.gltf", file.text()));
    EXPECT_EQ(loaded.scene.images.size(), 1U);
    expectLine(loaded, Report::Kind::kRepaired, "/images/1/uri", "beside the scene");
    EXPECT_TRUE(std::any_of(loaded.files.begin(), loaded.files.end(), [](const auto& path) {
        return path.filename() == "wood.png";
    })) << "watched for changes";
}

TEST(HabitsTest, UnitsAreScaledAsAsked) {
    GltfFile file = fileWithLamps({1000.0, 1000.0, 1000.0});
    file.json["cameras"] = {
        {{"type", "orthographic"},
         {"orthographic", {{"xmag", 200}, {"ymag", 100}, {"znear", 10}, {"zfar", 5000}}}}};
    file.addNode({{"camera", 0}, {"translation", {100, 200, 300}}});
    const LoadedScene loaded = loadScaled(file, 0.01, 5.0);
    EXPECT_NEAR(loaded.scene.cameras.at(0).frame.position.z, 3.0, 1e-12);
    EXPECT_NEAR(loaded.scene.cameras.at(0).nearMetres, 0.1, 1e-12);
    EXPECT_NEAR(std::get<OrthographicLens>(loaded.scene.cameras[0].lens).halfWidth, 2.0, 1e-12);
    EXPECT_NEAR(loaded.scene.spotLights.at(1).frame.position.x, 0.1, 1e-12);
    EXPECT_NEAR(loaded.scene.spotLights[1].rangeMetres, 0.07, 1e-12);
    EXPECT_NEAR(loaded.scene.spotLights[1].intensityCandela, 5000.0, 1e-9);
    EXPECT_NEAR(sceneBounds(loaded.scene).high.x, 0.01, 1e-9);
}

TEST(HabitsTest, CentimetresAreGuessedByTheLampsSpacing) {
    expectLine(load(fileWithLamps({1e4, 1e4, 1e4}, 10.0)), Report::Kind::kHint, "", "centimetres");
    EXPECT_EQ(reportText(load(fileWithLamps({1e4, 1e4, 1e4}, 1.0))), "");
    EXPECT_EQ(reportText(load(fileWithLamps({1e4, 1e4}, 10.0))), "");  // too few to say
    EXPECT_EQ(loadScaled(fileWithLamps({1e4, 1e4, 1e4}, 10.0), 0.01, 1.0).report.entries().size(),
              0U);
}

TEST(HabitsTest, LampsWithoutUnitsAreGuessedByTheBrightest) {
    expectLine(load(fileWithLamps({20.0, 50.0})), Report::Kind::kHint, "", "household bulb");
    EXPECT_EQ(reportText(load(fileWithLamps({20.0, 5000.0}))), "");
    EXPECT_EQ(reportText(load(fileWithLamps({20.0}))), "");
    EXPECT_EQ(loadScaled(fileWithLamps({20.0, 50.0}), 1.0, 683.0).report.entries().size(), 0U);
}

}  // namespace
}  // namespace ribalta::test
