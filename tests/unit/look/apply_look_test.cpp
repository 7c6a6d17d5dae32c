// A look brought to a scene: lamps by name, light maps by file, and what is not there.
#include "look/apply_look.h"

#include <gtest/gtest.h>

#include "support/expect_error.h"
#include "support/make_png.h"
#include "support/test_folder.h"

namespace ribalta {
namespace {

using test::expectError;
using test::TestFolder;

// Spots "a", "b", "a"; a point light "a", a directional one "sun".
Scene makeScene() {
    Scene scene;
    for (const char* name : {"a", "b", "a"}) {
        SpotLight spot;
        spot.name = name;
        spot.intensityCandela = 10.0;
        scene.spotLights.push_back(spot);
    }
    scene.pointLights.emplace_back();
    scene.pointLights.back().name = "a";
    scene.pointLights.back().intensityCandela = 10.0;
    scene.directionalLights.emplace_back();
    scene.directionalLights.back().name = "sun";
    scene.directionalLights.back().illuminanceLux = 10.0;
    return scene;
}

LampChange changeOf(const std::string& name, int number = 0) {
    LampChange change;
    change.name = name;
    change.number = number;
    return change;
}

std::vector<double> intensities(const Scene& scene) {
    std::vector<double> list;
    for (const LampId& lamp : lampsOf(scene)) {
        list.push_back(intensityOf(scene, lamp));
    }
    return list;
}

Scene applied(const std::vector<LampChange>& changes) {
    Scene scene = makeScene();
    LookLightMaps lightMaps;
    applyLamps(changes, lightMaps, scene);
    return scene;
}

TEST(ApplyLamps, FindsLampsOfOneNameByTheirNumber) {
    std::vector<LampChange> changes = {changeOf("a", 1), changeOf("a", 2), changeOf("sun")};
    changes[0].intensity = 1.0;
    changes[1].intensity = 2.0;
    changes[2].intensity = 3.0;
    EXPECT_EQ(intensities(applied(changes)), (std::vector<double>{10, 10, 1, 2, 3}));
}

TEST(ApplyLamps, OffAndSolo) {
    std::vector<LampChange> changes = {changeOf("b"), changeOf("sun")};
    changes[0].off = true;
    EXPECT_EQ(intensities(applied(changes)), (std::vector<double>{10, 0, 10, 10, 10}));
    changes[1].solo = true;
    EXPECT_EQ(intensities(applied(changes)), (std::vector<double>{0, 0, 0, 0, 10}));
    changes[0].solo = true;  // but off
    EXPECT_EQ(intensities(applied(changes)), (std::vector<double>{0, 0, 0, 0, 10}));
}

TEST(ApplyLamps, SoloOfALampThatIsNotThereDarkensNothing) {
    std::vector<LampChange> changes = {changeOf("nobody")};
    changes[0].solo = true;
    EXPECT_EQ(intensities(applied(changes)), (std::vector<double>{10, 10, 10, 10, 10}));
    EXPECT_EQ(lampsNotThere(changes, makeScene()), (std::vector<std::string>{"nobody"}));
    EXPECT_EQ(lampsNotThere({changeOf("a", 3)}, makeScene()),
              (std::vector<std::string>{"a (number 3)"}));
}

TEST(ApplyLamps, TheInnerConeStaysWithinTheOuter) {
    std::vector<LampChange> changes = {changeOf("b")};
    changes[0].innerConeAngle = 0.5;
    changes[0].outerConeAngle = 0.3;
    const SpotLight spot = applied(changes).spotLights[1];
    EXPECT_EQ(spot.outerConeAngle, 0.3);
    EXPECT_EQ(spot.innerConeAngle, 0.3);
}

TEST(ApplyLamps, AFrameTakesTheSceneSPlace) {
    std::vector<LampChange> changes = {changeOf("b"), changeOf("a", 2), changeOf("sun")};
    const Frame frame = lookAt({1, 2, 3}, {4, 0, 3});
    for (LampChange& change : changes) {
        change.frame = frame;
    }
    const Scene scene = applied(changes);
    EXPECT_EQ(scene.spotLights[1].frame, frame);
    EXPECT_EQ(scene.pointLights[0].position, frame.position);
    EXPECT_EQ(scene.directionalLights[0].direction, frame.forward());
}

TEST(ApplyLamps, LightMapsAreReadOnceAndTakenAway) {
    const TestFolder folder;
    test::PngParts grey{2, 2, 8, 0};
    grey.rows = {std::string("\0\xff", 2), std::string("\xff\0", 2)};
    const auto file = folder.write("map.png", test::makePng(grey));
    Scene scene = makeScene();
    scene.images.emplace_back();
    scene.spotLights[0].lightMap = LightMap{0, 0.5};
    const Scene before = scene;
    std::vector<LampChange> changes = {changeOf("a", 0), changeOf("b"), changeOf("a", 1)};
    for (LampChange& change : changes) {
        change.lightMap.file = file;
    }
    changes[1].lightMap.rotationRadians = 1.0;
    LookLightMaps lightMaps;
    applyLamps(changes, lightMaps, scene);
    applyLamps(changes, lightMaps, scene);
    ASSERT_EQ(scene.images.size(), 2U);
    EXPECT_EQ(scene.images[1].width, 2);
    EXPECT_EQ(scene.spotLights[0].lightMap, (LightMap{1, 0.5}));
    EXPECT_EQ(scene.spotLights[1].lightMap, (LightMap{1, 1.0}));
    EXPECT_EQ(lightMaps.files(), std::vector<std::filesystem::path>{file});

    changes[0].lightMap.file.emplace();
    scene.spotLights = before.spotLights;
    applyLamps(changes, lightMaps, scene);
    EXPECT_FALSE(scene.spotLights[0].lightMap);
}

TEST(ApplyLamps, ABrokenNewVersionOfALightMapKeepsTheOld) {
    const TestFolder folder;
    test::PngParts grey{1, 1, 8, 0};
    grey.rows = {std::string("\xff", 1)};
    const auto file = folder.write("map.png", test::makePng(grey));
    Scene scene = makeScene();
    LookLightMaps lightMaps;
    EXPECT_EQ(lightMaps.use(file, scene), 0);
    folder.write("map.png", "half of a pic");
    expectError(ErrorKind::kBadInput, {"map.png"}, [&] { lightMaps.reload(file, scene); });
    EXPECT_EQ(lightMaps.use(file, scene), 0);
    EXPECT_FALSE(scene.images[0].pixels.empty());
    folder.write("map.png", test::makePng(grey));
    lightMaps.reload(file, scene);
    EXPECT_EQ(lightMaps.use(file, scene), 1);
    EXPECT_TRUE(scene.images[0].pixels.empty());
}

TEST(ApplyLamps, ALightMapThatCannotBeReadIsNamed) {
    const TestFolder folder;
    folder.write("broken.png", "no picture");
    for (const char* file : {"broken.png", "missing.png"}) {
        std::vector<LampChange> changes = {changeOf("b")};
        changes[0].lightMap.file = folder / file;
        expectError(ErrorKind::kBadInput, {file}, [&] { applied(changes); });
    }
}

TEST(LampChange, KnowsWhetherItChangesAnything) {
    LampChange change = changeOf("a", 3);
    EXPECT_TRUE(change.isIdle());
    change.solo = true;
    EXPECT_FALSE(change.isIdle());
}

// A spot whose intensity goes from 100 to 300 cd and whose cones open, in 2 s.
Scene makeAnimatedScene() {
    Scene scene = makeScene();
    Animation& animation = scene.animations.emplace_back();
    const auto play = [&](Dial::Numbers numbers, const glm::vec4& from, const glm::vec4& to) {
        Dial& dial = scene.dials.emplace_back();
        dial.numbers = numbers;
        dial.owners = {1};
        dial.rest = dial.now = glm::dvec4(from);
        animation.samplers.push_back(
            {AnimationSampler::Interpolation::kLinear, {0, 2}, {from, to}});
        const int last = int(scene.dials.size()) - 1;
        animation.channels.push_back({last, last, AnimationChannel::Part::kDial, 0, 2});
    };
    play(Dial::Numbers::kIntensity, glm::vec4(100), glm::vec4(300));
    play(Dial::Numbers::kCone, {0.1, 0.2, 0, 0}, {0.3, 0.4, 0, 0});
    return scene;
}

TEST(AnimatedLamps, TheLooksValueWins) {
    std::vector<LampChange> changes = {changeOf("b")};
    LookLightMaps lightMaps;
    Scene scene = makeAnimatedScene();
    const auto lampAt = [&](double seconds) -> const SpotLight& {
        poseAt(LookTime{seconds, ""}, scene);
        applyLamps(changes, lightMaps, scene);
        return scene.spotLights[1];
    };
    EXPECT_EQ(lampAt(1.0).intensityCandela, 200.0);
    EXPECT_NEAR(lampAt(1.0).outerConeAngle, 0.3, 1e-7);
    changes[0].intensity = 7.0;
    EXPECT_EQ(lampAt(0.0).intensityCandela, 7.0);
    EXPECT_EQ(lampAt(2.0).intensityCandela, 7.0);
    EXPECT_NEAR(lampAt(2.0).outerConeAngle, 0.4, 1e-7) << "what the look says nothing of";
    // The inner cone stays within what the look gives as outer one, and comes back.
    changes[0].outerConeAngle = 0.25;
    EXPECT_EQ(lampAt(2.0).outerConeAngle, 0.25);
    EXPECT_EQ(lampAt(2.0).innerConeAngle, 0.25);
    EXPECT_NEAR(lampAt(0.0).innerConeAngle, 0.1, 1e-7);
    changes[0].off = true;
    EXPECT_EQ(lampAt(1.0).intensityCandela, 0.0);
    // Taken back, it plays as before.
    changes.clear();
    EXPECT_EQ(lampAt(1.0).intensityCandela, 200.0);
    EXPECT_NEAR(lampAt(1.0).innerConeAngle, 0.2, 1e-7);
    poseAt(std::nullopt, scene);
    EXPECT_EQ(scene.spotLights[1].intensityCandela, 100.0);
}

}  // namespace
}  // namespace ribalta
