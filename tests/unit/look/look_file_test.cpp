// Looks as files: what is written is read again, number for number; what is wrong is named.
#include "look/look_file.h"

#include <fstream>
#include <numbers>
#include <sstream>

#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include "support/expect_error.h"
#include "support/test_folder.h"

namespace ribalta {
namespace {

using test::expectError;
using test::TestFolder;

Look fullLook(const TestFolder& folder) {
    Look look;
    look.scene = "stage.glb";
    look.camera.emplace();
    look.camera->name = "front";
    look.camera->frame = lookAt({1.0, 2.5, 1.0 / 3.0}, {0.0, 1.0, -4.0});
    look.camera->lens = PerspectiveLens{0.7, 16.0 / 9.0};
    look.camera->farMetres = 100.0;
    look.bookmarks.push_back(Camera{});
    look.bookmarks[0].name = "from the pit";
    look.bookmarks[0].lens = OrthographicLens{2.0, 1.0};
    look.bookmarks[0].farMetres = 10.0;
    look.size = glm::ivec2(1280, 721);
    look.time = LookTime{2.375, "pan"};
    LampChange spot;
    spot.name = "Spot \"1\" \xc3\xa4";
    spot.number = 2;
    spot.solo = true;
    spot.intensity = 12345.6789;
    spot.color = glm::vec3(1.0F, 0.5F, 0.1F);
    spot.innerConeAngle = 0.1;
    spot.outerConeAngle = 0.3;
    spot.frame = lookAt({0.0, 5.0, 0.0}, {0.3, 0.0, 0.1});
    spot.lightMap.file = folder / "maps/star.png";
    spot.lightMap.rotationRadians = 0.25;
    LampChange dark;
    dark.name = "Key";
    dark.off = true;
    dark.lightMap.file.emplace();
    look.lamps = {spot, dark};
    look.haze.scatteringPerMetre = 0.03;
    look.haze.absorptionPerMetre = 0.001;
    look.haze.phase = {PhaseFunction::Kind::kHenyeyGreenstein, 0.6, PhaseFunction{}.k};
    look.beams.method = BeamMethod::kClipped;
    look.beams.planes = 48;
    look.beams.cellsAcross = 20;
    look.beams.cellsDown = 12;
    look.sky = SkyLook{SkyKind::kSingle, SunInSky{0.1, 2.0}, 30.0};
    look.ambientLux = 0.1;
    look.ev100 = 7.3;
    look.toneCurve = ToneCurve::kAgx;
    return look;
}

// Angles pass through degrees and rotations through quaternions: the last digits may differ.
void expectNear(const Look& look, const Look& other) {
    constexpr double kLastDigits = 1e-14;
    Look same = other;
    ASSERT_EQ(look.lamps.size(), other.lamps.size());
    const auto nearFrame = [&](const Frame& a, const Frame& b) {
        EXPECT_EQ(a.position, b.position);
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_LT(glm::length(a.worldFromLocal[axis] - b.worldFromLocal[axis]), kLastDigits);
        }
    };
    nearFrame(look.camera->frame, other.camera->frame);
    same.camera->frame = look.camera->frame;
    const auto fov = [](const Look& of) {
        return std::get<PerspectiveLens>(of.camera->lens).verticalFov;
    };
    EXPECT_NEAR(fov(look), fov(other), kLastDigits);
    same.camera->lens = look.camera->lens;
    for (std::size_t i = 0; i < look.lamps.size(); ++i) {
        const LampChange& a = look.lamps[i];
        LampChange& b = same.lamps[i];
        ASSERT_EQ(a.frame.has_value(), b.frame.has_value());
        if (a.frame) {
            nearFrame(*a.frame, *b.frame);
        }
        b.frame = a.frame;
        EXPECT_NEAR(a.innerConeAngle.value_or(0), b.innerConeAngle.value_or(0), kLastDigits);
        EXPECT_NEAR(a.outerConeAngle.value_or(0), b.outerConeAngle.value_or(0), kLastDigits);
        b.innerConeAngle = a.innerConeAngle;
        b.outerConeAngle = a.outerConeAngle;
    }
    EXPECT_NEAR(look.sky->sun->elevation, other.sky->sun->elevation, kLastDigits);
    EXPECT_NEAR(look.sky->sun->azimuth, other.sky->sun->azimuth, kLastDigits);
    same.sky->sun = look.sky->sun;
    EXPECT_EQ(look, same);
}

TEST(LookFile, KeepsAll) {
    const TestFolder folder;
    const Look look = fullLook(folder);
    writeLook(look, folder / "a.json");
    expectNear(readLook(folder / "a.json"), look);
}

TEST(LookFile, KeepsAnOrthographicCameraAndDefaults) {
    const TestFolder folder;
    Look look;
    look.camera.emplace();
    look.camera->lens = OrthographicLens{3.0, 2.0};
    look.camera->farMetres = 50.0;
    writeLook(look, folder / "a.json");
    EXPECT_EQ(readLook(folder / "a.json"), look);
    EXPECT_EQ(readLook(folder.write("least.json", R"({"ribalta_look": 1})")), Look{});
}

TEST(LookFile, LightMapsLieRelativeToTheFile) {
    const TestFolder folder;
    writeLook(fullLook(folder), folder / "a.json");
    std::ifstream stream(folder / "a.json");
    std::stringstream text;
    text << stream.rdbuf();
    EXPECT_NE(text.str().find("\"maps/star.png\""), std::string::npos) << text.str();
    EXPECT_EQ(text.str().find(folder.path().string()), std::string::npos) << text.str();
}

TEST(LookFile, LightMapsAreFoundFromAFolderWithDots) {
    const TestFolder folder;
    std::filesystem::create_directories(folder / "looks");
    std::filesystem::create_directories(folder / "other");
    Look look;
    look.lamps.emplace_back();
    look.lamps[0].lightMap.file = folder / "other/star.png";
    const std::filesystem::path file = folder / "other/../looks/a.json";
    writeLook(look, file);
    EXPECT_EQ(readLook(file), look);
    EXPECT_EQ(readLook(folder / "looks/a.json"), look);
}

TEST(LookFile, AFailedWriteLeavesWhatWasThere) {
    const TestFolder folder;
    expectError(ErrorKind::kJobFailed, {"none/a.json"},
                [&] { writeLook(Look{}, folder / "none/a.json"); });
}

struct BadLook {
    const char* json;
    std::vector<std::string> words;
};

TEST(LookFile, WhatIsWrongIsNamed) {
    const std::vector<BadLook> cases = {
        {"[1]", {"expected a look"}},
        {"{", {"line 1", "not valid JSON"}},
        {"{}", {"/ribalta_look", "missing"}},
        {R"({"ribalta_look": 2})", {"/ribalta_look", "newer"}},
        {R"({"ribalta_look": "1"})", {"/ribalta_look", "whole number"}},
        {R"({"ribalta_look": 1, "hase": {}})", {"/hase", "there are", "haze"}},
        {R"({"ribalta_look": 1, "haze": 3})", {"/haze", "is 3", "an object"}},
        {R"({"ribalta_look": 1, "haze": {"scattering": -1}})", {"/haze/scattering", "-1"}},
        {R"({"ribalta_look": 1, "haze": {"phase": "foo"}})", {"/haze/phase", "foo", "gibbons"}},
        {R"({"ribalta_look": 1, "haze": {"g": 0.5}})", {"/haze/g"}},
        {R"({"ribalta_look": 1, "size": [100]})", {"/size", "2 numbers"}},
        {R"({"ribalta_look": 1, "size": [0, 20]})", {"/size/0", "1 .. 16384"}},
        {R"({"ribalta_look": 1, "exposure": "bright"})", {"/exposure", "auto"}},
        {R"({"ribalta_look": 1, "exposure": 1e9})", {"/exposure", "-60 .. 60"}},
        {R"({"ribalta_look": 1, "beams": {"method": "x"}})", {"/beams/method", "adaptive"}},
        {R"({"ribalta_look": 1, "beams": {"planes": 1.5}})", {"/beams/planes", "whole number"}},
        {R"({"ribalta_look": 1, "sky": {"model": "x"}})", {"/sky/model", "bruneton"}},
        {R"({"ribalta_look": 1, "sky": {"sun_azimuth_degrees": 1}})",
         {"/sky/sun_elevation_degrees", "missing"}},
        {R"({"ribalta_look": 1, "time": {"animation": "pan"}})", {"/time/seconds", "missing"}},
        {R"({"ribalta_look": 1, "time": {"seconds": -1}})", {"/time/seconds", "-1"}},
        {R"({"ribalta_look": 1, "lamps": {}})", {"/lamps", "array of objects"}},
        {R"({"ribalta_look": 1, "lamps": [{}]})", {"/lamps/0/name", "missing"}},
        {R"({"ribalta_look": 1, "lamps": [{"name": "a"}, {"name": "b"}, {"name": "a"}]})",
         {"/lamps/2/name", "there already"}},
        {R"({"ribalta_look": 1, "lamps": [{"name": "a", "outer_cone_degrees": 0}]})",
         {"/lamps/0/outer_cone_degrees", "0.01"}},
        {R"({"ribalta_look": 1, "lamps": [{"name": "a", "on": 1}]})", {"/lamps/0/on", "true"}},
        {R"({"ribalta_look": 1, "lamps": [{"name": "a", "color": [1, 1]}]})",
         {"/lamps/0/color", "3 numbers"}},
        {R"({"ribalta_look": 1, "lamps": [{"name": "a", "position": [1, 1, 1]}]})",
         {"/lamps/0/rotation", "missing"}},
        {R"({"ribalta_look": 1,
             "lamps": [{"name": "a", "position": [1, 1, 1], "rotation": [1, 1, 0, 0]}]})",
         {"/lamps/0/rotation", "length"}},
        {R"({"ribalta_look": 1,
             "lamps": [{"name": "a", "inner_cone_degrees": 9, "outer_cone_degrees": 3}]})",
         {"/lamps/0/inner_cone_degrees", "wider"}},
        {R"({"ribalta_look": 1, "lamps": [{"name": "a", "light_map": {"file": ""}}]})",
         {"/lamps/0/light_map/file", "null"}},
        {R"({"ribalta_look": 1, "camera": {"position": [0, 0, 0], "rotation": [0, 0, 0, 1]}})",
         {"/camera", "vertical_fov_degrees"}},
        {R"({"ribalta_look": 1, "camera": {"position": [0, 0, 0], "rotation": [0, 0, 0, 1],
             "vertical_fov_degrees": 40, "near": 2, "far": 1}})",
         {"/camera/far", "beyond"}},
    };
    const TestFolder folder;
    for (const BadLook& bad : cases) {
        SCOPED_TRACE(bad.json);
        std::vector<std::string> words = bad.words;
        words.emplace_back("a.json");
        expectError(ErrorKind::kBadInput, words,
                    [&] { readLook(folder.write("a.json", std::string_view(bad.json))); });
    }
    expectError(ErrorKind::kBadInput, {"not_there.json"},
                [&] { readLook(folder / "not_there.json"); });
}

}  // namespace
}  // namespace ribalta
