// Photometric files: parsed, held against closed forms, projected by spots, refused with a line.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "base/angles.h"
#include "gltf/parse_ies.h"
#include "gltf/project_web.h"
#include "gltf_file.h"
#include "support/expect_error.h"

namespace ribalta::test {
namespace {

using gltf::IesProfile;
using gltf::PhotometricWeb;
using nlohmann::json;

const Place kPlace{"lamp.ies", ""};

glm::dvec3 directionC(double vertical, double horizontal) {
    const double v = vertical * kPi / 180.0;
    const double h = horizontal * kPi / 180.0;
    return {std::sin(v) * std::cos(h), std::sin(v) * std::sin(h), -std::cos(v)};
}

std::string numbers(const std::vector<double>& values) {
    std::string text;
    for (const double value : values) {
        text.append(std::to_string(value)).append(" ");
    }
    return text + "\n";
}

std::vector<double> steps(double first, double last, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) {
        values.push_back(first + (last - first) * i / (count - 1));
    }
    return values;
}

struct IesParts {
    std::string head = "IESNA:LM-63-2002\n[TEST] made by hand\nTILT=NONE\n";
    int type = 1;
    std::string factors = "1 1 100\n";  // ballast, ballast-lamp, watts
    double multiplier = 1.0;
    std::vector<double> vertical = steps(0, 180, 181);
    std::vector<double> horizontal = {0};
};

// `candela` of vertical and horizontal angle.
template <typename Candela>
std::string iesText(const IesParts& parts, const Candela& candela) {
    std::string text = parts.head + "1 1000 " + std::to_string(parts.multiplier) + " " +
                       std::to_string(parts.vertical.size()) + " " +
                       std::to_string(parts.horizontal.size()) + " " + std::to_string(parts.type) +
                       " 2 0 0 0\n" + parts.factors + numbers(parts.vertical) +
                       numbers(parts.horizontal);
    for (const double h : parts.horizontal) {
        for (const double v : parts.vertical) {
            text.append(std::to_string(candela(v, h))).append("\n");
        }
    }
    return text;
}

double cosine(double vertical) {
    return std::max(0.0, std::cos(vertical * kPi / 180.0));
}

TEST(IesTest, AnIsotropicWebIsFlat) {
    const IesProfile profile =
        gltf::parseIes(iesText({}, [](double, double) { return 250.0; }), kPlace);
    EXPECT_TRUE(profile.remarks.empty());
    const gltf::ProjectedWeb projected = gltf::projectWeb(profile.web);
    EXPECT_DOUBLE_EQ(projected.candela, 250.0);
    EXPECT_DOUBLE_EQ(projected.halfAngle, kMaxConeAngle);
    // A sphere without its cap of 80 degrees.
    EXPECT_NEAR(projected.lostShare, 1.0 - (1.0 - std::cos(kMaxConeAngle)) / 2.0, 1e-3);
    const auto* levels = reinterpret_cast<const float*>(projected.lightMap.pixels.data());
    for (std::size_t i = 0; i < projected.lightMap.pixels.size() / sizeof(float); ++i) {
        ASSERT_FLOAT_EQ(levels[i], 1.0F) << i;
    }
}

TEST(IesTest, ACosineWebIsACosine) {
    const IesProfile profile =
        gltf::parseIes(iesText({}, [](double v, double) { return 1000.0 * cosine(v); }), kPlace);
    for (const double v : {0.0, 0.25, 10.5, 45.0, 77.77, 90.0, 120.0, 180.0}) {
        EXPECT_NEAR(profile.web.at(directionC(v, 123.0)), 1000.0 * cosine(v), 0.05) << v;
    }
    const gltf::ProjectedWeb projected = gltf::projectWeb(profile.web);
    // Of its pi * 1000 lumens those past a cone are cos^2 of its angle.
    EXPECT_NEAR(projected.lostShare, std::pow(std::cos(kMaxConeAngle), 2), 1e-3);
    // On the picture's plane at the distance 1 the cosine is 1 / distance.
    const auto* levels = reinterpret_cast<const float*>(projected.lightMap.pixels.data());
    const double reach = std::tan(projected.halfAngle);
    for (int y = 3; y < gltf::kWebMapSide; y += 50) {
        for (int x = 5; x < gltf::kWebMapSide; x += 50) {
            const double right = (2.0 * (x + 0.5) / gltf::kWebMapSide - 1.0) * reach;
            const double up = (1.0 - 2.0 * (y + 0.5) / gltf::kWebMapSide) * reach;
            const double expected = 1000.0 / std::sqrt(1.0 + right * right + up * up);
            EXPECT_NEAR(levels[4 * (y * gltf::kWebMapSide + x)] * projected.candela, expected, 0.1);
        }
    }
}

TEST(IesTest, ANarrowWebHasANarrowCone) {
    IesParts parts;
    parts.vertical = {0, 19.9, 20, 90};
    const gltf::ProjectedWeb projected = gltf::projectWeb(
        gltf::parseIes(iesText(parts, [](double v, double) { return v < 20 ? 50.0 : 0.0; }), kPlace)
            .web);
    EXPECT_NEAR(projected.halfAngle, 20.0 * kPi / 180.0, 1e-9);
    EXPECT_LT(projected.lostShare, 1e-3);
}

// A web that is brighter towards +X than towards +Y, in as much of the circle as a file may have.
TEST(IesTest, WhatACircleLacksIsMirrored) {
    const auto candela = [](double, double h) {
        return 100.0 + 50.0 * std::cos(2.0 * h * kPi / 180.0);
    };
    for (const std::vector<double>& horizontal :
         {steps(0, 90, 91), steps(0, 180, 181), steps(0, 360, 361), steps(90, 270, 181),
          steps(0, 359, 360)}) {
        IesParts parts;
        parts.horizontal = horizontal;
        parts.vertical = {0, 90};
        const PhotometricWeb web = gltf::parseIes(iesText(parts, candela), kPlace).web;
        for (double h = -180.0; h < 540.0; h += 7.3) {
            EXPECT_NEAR(web.at(directionC(30.0, h)), candela(0, h), 0.05)
                << h << " of " << horizontal.front() << ".." << horizontal.back();
        }
        EXPECT_EQ(web.at(directionC(90.1, 0.0)), 0.0);
    }
}

// Along each axis alone all types agree on what an angle is; between them a formula of its own.
TEST(IesTest, TypesSpanTheSphereEachInItsWay) {
    IesParts parts;
    parts.vertical = steps(-90, 90, 181);
    parts.horizontal = steps(-90, 90, 181);
    const auto candela = [](double v, double h) { return 500.0 + v + 2.0 * h; };
    const double v = 0.3;
    const double h = 0.5;
    const double expected = candela(v * 180.0 / kPi, h * 180.0 / kPi);
    parts.type = 2;
    EXPECT_NEAR(gltf::parseIes(iesText(parts, candela), kPlace)
                    .web.at({std::cos(h) * std::sin(v), -std::sin(h), -std::cos(h) * std::cos(v)}),
                expected, 1e-3);
    parts.type = 3;
    EXPECT_NEAR(gltf::parseIes(iesText(parts, candela), kPlace)
                    .web.at({std::sin(v), -std::sin(h) * std::cos(v), -std::cos(h) * std::cos(v)}),
                expected, 1e-3);
    for (const int type : {2, 3}) {
        parts.type = type;
        const PhotometricWeb web = gltf::parseIes(iesText(parts, candela), kPlace).web;
        EXPECT_NEAR(web.at({0, 0, -1}), 500.0, 1e-3);
        EXPECT_NEAR(web.at({std::sin(v), 0, -std::cos(v)}), 500.0 + v * 180.0 / kPi, 1e-3);
        EXPECT_NEAR(web.at({0, std::sin(h), -std::cos(h)}), 500.0 - 2.0 * h * 180.0 / kPi, 1e-3);
        EXPECT_EQ(web.at({0, 0, 1}), 0.0);
    }
}

TEST(IesTest, FactorsOfTheVersions) {
    const auto at = [](const std::string& head) {
        IesParts parts;
        parts.head = head;
        parts.multiplier = 2.0;
        parts.factors = "0.5 0.25 100\n";
        return gltf::parseIes(iesText(parts, [](double, double) { return 80.0; }), kPlace)
            .web.at({0, 0, -1});
    };
    // The second factor is one of the lamp's until 1995.
    EXPECT_DOUBLE_EQ(at("a luminaire\nTILT=NONE\n"), 20.0);
    EXPECT_DOUBLE_EQ(at("IESNA91\nTILT=NONE\n"), 20.0);
    EXPECT_DOUBLE_EQ(at("IESNA:LM-63-1995\r\n[MORE] x\r\nTILT=NONE\r\n"), 20.0);
    EXPECT_DOUBLE_EQ(at("IESNA:LM-63-2002\rTILT=NONE\r"), 80.0);
    EXPECT_DOUBLE_EQ(at("IES:LM-63-2019\nTILT=NONE\n"), 80.0);
}

TEST(IesTest, TiltIsSkippedAndSaid) {
    for (const char* tilt : {"TILT=INCLUDE\n1\n3\n0 45 90\n1 0.9 0.8\n", "TILT=lamp.tlt\n"}) {
        IesParts parts;
        parts.head = std::string("IESNA91\n") + tilt;
        const IesProfile profile =
            gltf::parseIes(iesText(parts, [](double, double) { return 7.0; }), kPlace);
        ASSERT_EQ(profile.remarks.size(), 1U);
        EXPECT_NE(profile.remarks[0].find("tilt"), std::string::npos);
        EXPECT_DOUBLE_EQ(profile.web.at({0, 0, -1}), 7.0);
    }
}

TEST(IesTest, BrokenFilesAreRefusedAtALine) {
    const std::string good = "IESNA91\nTILT=NONE\n1 -1 1 2 1 1 2 0 0 0\n1 1 50\n0 90\n0\n5 6\n";
    ASSERT_NO_THROW(gltf::parseIes(good, kPlace));
    ASSERT_NO_THROW(
        gltf::parseIes("IESNA91\nTILT=NONE\n+1 -1,1,2,1 1 2 0 0 0 1 1 50 0 9e1 0 5 6", kPlace));
    const auto expectRefused = [](const std::string& text, const std::vector<std::string>& words) {
        expectError(ErrorKind::kBadInput, words, [&] { gltf::parseIes(text, kPlace); });
    };
    expectRefused("", {"lamp.ies", "TILT="});
    expectRefused("IESNA91\n[A] b\n", {"TILT="});
    expectRefused(good.substr(0, good.size() - 3), {"line 7", "ends before its candela"});
    const std::string head = "IESNA91\nTILT=NONE\n";
    expectRefused(head + "1 -1 1 two 1", {"line 3", "two is no number of vertical angles"});
    expectRefused(head + "1 -1 1 99999 99999 1 2 0 0 0\n1 1 50\n", {"line 4", "99999 x 99999"});
    expectRefused(head + "1 -1 1 2.5 1 1", {"line 3", "2.500000"});
    expectRefused(head + "1 -1 1 2 1 4", {"line 3", "photometric type", "1 to 3"});
    expectRefused(head + "1 -1 1 1 1 1 2 0 0 0\n1 1 50\n0\n0\n5\n", {"two or more"});
    expectRefused(head + "1 -1 1 2 1 1 2 0 0 0\n1 1 50\n0 0\n0\n5 5", {"line 5", "does not come"});
    expectRefused(head + "1 -1 1 2 1 1 2 0 0 0\n1 1 50\n0 181\n0\n5 5", {"line 5", "not within"});
    expectRefused(head + "1 -1 -1 2 1 1 2 0 0 0\n1 1 50\n0 90\n0\n5 5", {"no less than 0"});
    expectRefused(head + "1 -1 1 2 1 1 2 0 0 0\n1 1 50\n0 90\n0\n5 nan", {"line 7", "nan"});
    expectRefused(head + "1 -1 1 2 1 1 2 0 0 0\n1 1 50\n0 90\n0\n5 1e13", {"line 7", "any lamp"});
    const IesProfile mended =
        gltf::parseIes(head + "1 -1 1 2 1 1 2 0 0 0\n1 1 50\n0 90\n0\n5 -1", kPlace);
    EXPECT_EQ(mended.remarks.size(), 1U);
    EXPECT_EQ(mended.web.candela[1], 0.0);
}

// A lamp of the extension, its profile given by a bufferView.
GltfFile fileWithPhotometry(const std::string& ies) {
    GltfFile file = triangleFile();
    file.json["extensionsUsed"] = file.json["extensionsRequired"] = {"EXT_lights_ies"};
    file.json["extensions"]["EXT_lights_ies"]["lights"] =
        json::array({{{"bufferView", file.addViewBytes(ies.data(), ies.size())},
                      {"mimeType", "application/x-ies-lm-63"}}});
    file.addNode(
        {{"name", "web"},
         {"extensions",
          {{"EXT_lights_ies", {{"light", 0}, {"multiplier", 3.0}, {"color", {1.0, 0.5, 0.0}}}}}}});
    return file;
}

TEST(IesTest, ALampIsASpotWithALightMap) {
    const std::string ies = iesText({}, [](double v, double) { return 100.0 * cosine(v); });
    GltfFile file = fileWithPhotometry(ies);
    file.addNode({{"extensions", {{"EXT_lights_ies", {{"light", 0}}}}}});
    const LoadedScene loaded = load(file);
    ASSERT_EQ(loaded.scene.spotLights.size(), 2U);
    const SpotLight& spot = loaded.scene.spotLights[0];
    EXPECT_EQ(spot.name, "web");
    EXPECT_NEAR(spot.intensityCandela, 300.0, 0.1);
    EXPECT_EQ(spot.color, glm::vec3(1.0F, 0.5F, 0.0F));
    EXPECT_NEAR(spot.outerConeAngle, kMaxConeAngle, 1e-9);
    ASSERT_TRUE(spot.lightMap);
    // One profile is projected once.
    EXPECT_EQ(spot.lightMap, loaded.scene.spotLights[1].lightMap);
    EXPECT_NEAR(loaded.scene.spotLights[1].intensityCandela, 100.0, 0.1);
    expectLine(loaded, Report::Kind::kIgnored, "/extensions/EXT_lights_ies/lights/0", "3.0 %");
}

TEST(IesTest, AFileBesideTheScene) {
    const TestFolder folder;
    GltfFile file = fileWithPhotometry("x");
    file.json["extensions"]["EXT_lights_ies"]["lights"][0] = {{"uri", "a%20lamp.ies"}};
    const std::filesystem::path path = file.writeTo(folder);
    const LoadedScene without = load(path);
    EXPECT_TRUE(without.scene.spotLights.empty());
    expectLine(without, Report::Kind::kIgnored, "/extensions/EXT_lights_ies/lights/0/uri",
               "no such file");
    folder.write("a lamp.ies", "IESNA91\nTILT=NONE\n1 -1 1 2 1 1 x");
    expectLine(load(path), Report::Kind::kIgnored, "/extensions/EXT_lights_ies/lights/0/uri",
               "line 3");
    folder.write("a lamp.ies", iesText({}, [](double, double) { return 1.0; }));
    const LoadedScene with = load(path);
    EXPECT_EQ(with.scene.spotLights.size(), 1U);
    EXPECT_EQ(with.files.size(), 2U);
}

TEST(IesTest, OddUsesAreReported) {
    const std::string ies = iesText({}, [](double, double) { return 1.0; });
    const auto loadWith = [&](const json& use) {
        GltfFile file = fileWithPhotometry(ies);
        file.json["nodes"][1]["extensions"]["EXT_lights_ies"] = use;
        return load(file);
    };
    const std::string node = "/nodes/1/extensions/EXT_lights_ies";
    for (const json& light : {json(1), json(-1), json("0"), json(0.5), json()}) {
        const LoadedScene loaded = loadWith({{"light", light}});
        EXPECT_TRUE(loaded.scene.spotLights.empty());
        expectLine(loaded, Report::Kind::kIgnored, node + "/light", "1 light profile;");
    }
    expectLine(loadWith({{"light", 0}, {"multiplier", -1}}), Report::Kind::kRepaired,
               node + "/multiplier", "1 is used");
    expectLine(loadWith({{"light", 0}, {"color", {1, "x", 0}}}), Report::Kind::kRepaired,
               node + "/color", "white");
    GltfFile file = fileWithPhotometry(ies);
    file.json["extensions"]["EXT_lights_ies"]["lights"][0] = 7;
    expectLine(load(file), Report::Kind::kIgnored, "/extensions/EXT_lights_ies/lights/0",
               "neither a uri");
    file.json["extensions"]["EXT_lights_ies"] = json::array();
    expectLine(load(file), Report::Kind::kIgnored, node + "/light", "0 light profiles");
}

TEST(IesTest, APunctualLightOnTheSameNodeIsItsStandIn) {
    GltfFile file = fileWithPhotometry(iesText({}, [](double, double) { return 1.0; }));
    file.json["extensions"]["KHR_lights_punctual"]["lights"] = json::array({{{"type", "point"}}});
    json& node = file.json["nodes"][1];
    node["extensions"]["KHR_lights_punctual"] = {{"light", 0}};
    const LoadedScene web = load(file);
    EXPECT_TRUE(web.scene.pointLights.empty());
    EXPECT_EQ(web.scene.spotLights.size(), 1U);
    // Without the web it is drawn.
    file.json["extensions"]["EXT_lights_ies"]["lights"][0]["bufferView"] = 0;
    const LoadedScene standIn = load(file);
    EXPECT_EQ(standIn.scene.pointLights.size(), 1U);
    EXPECT_TRUE(standIn.scene.spotLights.empty());
}

}  // namespace
}  // namespace ribalta::test
