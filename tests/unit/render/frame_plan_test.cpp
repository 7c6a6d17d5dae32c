// The plan line of small scenes: what a frame does not need is not in it.
#include "render/frame_plan.h"

#include <gtest/gtest.h>

#include "support/stage.h"

namespace ribalta::test {
namespace {

/// A floor, one spot above it and a camera that sees both.
struct SmallStage {
    Scene scene;
    Camera camera = makeCamera({0, 2, 8}, {0, 1, 0});
    FrameSettings settings;
    FrameCache cache;
    int floor = -1;

    explicit SmallStage(bool withFloor = true, bool withLamp = true) {
        settings.width = 64;
        settings.height = 48;
        settings.ev100 = 5.0;
        settings.beams.planes = 8;
        if (withFloor) {
            floor = addShape(scene, makeQuad({0, 0, 0}, {5, 0, 0}, {0, 0, -5}),
                             makeMaterial(glm::vec3(0.5F)));
        }
        if (withLamp) {
            scene.spotLights.push_back(makeSpot({0, 5, 0}, {0, 0, 0}, 0.3));
        }
    }

    FramePlan plan() const { return planFrame(scene, camera, settings, cache); }
    std::string line() const { return plan().describe(); }
};

TEST(FramePlanLine, EverythingThereIs) {
    EXPECT_EQ(SmallStage().line(), "shadow_map[1] forward beams[1] tonemap");
}

TEST(FramePlanLine, ClearAirHasNoBeams) {
    SmallStage stage;
    stage.settings.haze.scatteringPerMetre = 0.0;
    EXPECT_EQ(stage.line(), "shadow_map[1] forward tonemap");
    stage.settings.haze.absorptionPerMetre = 0.1;
    EXPECT_EQ(stage.line(), "shadow_map[1] forward tonemap") << "air that only absorbs";
}

TEST(FramePlanLine, NoLamps) {
    const SmallStage stage(true, false);
    EXPECT_EQ(stage.line(), "forward tonemap");
    EXPECT_EQ(stage.plan().lampsSkipped, 0);
}

TEST(FramePlanLine, DarkLampsAreSkipped) {
    for (int how = 0; how < 3; ++how) {
        SmallStage stage;
        SpotLight& lamp = stage.scene.spotLights[0];
        lamp.intensityCandela = how == 0 ? 0.0 : lamp.intensityCandela;
        lamp.color = how == 1 ? glm::vec3(0.0F) : lamp.color;
        lamp.rangeMetres = how == 2 ? 0.0 : lamp.rangeMetres;
        EXPECT_EQ(stage.line(), "forward tonemap") << "case " << how;
        EXPECT_EQ(stage.plan().lampsSkipped, 1);
        EXPECT_TRUE(stage.plan().lamps.empty());
    }
}

TEST(FramePlanLine, ALampThatShinesAwayBehindTheCameraIsSkipped) {
    SmallStage stage;
    stage.scene.spotLights[0] = makeSpot({0, 5, 20}, {0, 5, 30}, 0.3);
    EXPECT_EQ(stage.line(), "forward tonemap");
    EXPECT_EQ(stage.plan().lampsSkipped, 1);
}

TEST(FramePlanLine, ALampBesideTheViewThatLightsNothingInItIsSkipped) {
    SmallStage stage;
    // It lights the unseen shape only, and its beam passes far to the left of the picture.
    addShape(stage.scene, makeBox({-60, 0, 0}, {-59, 1, 1}), makeMaterial(glm::vec3(0.5F)));
    stage.scene.spotLights[0] = makeSpot({-60, 5, 0}, {-60, 0, 0}, 0.2);
    EXPECT_EQ(stage.line(), "forward tonemap");
    EXPECT_EQ(stage.plan().forward->opaque, std::vector<int>{0}) << "the unseen shape is not drawn";
}

TEST(FramePlanLine, ALampBehindTheCameraThatLightsTheFloorIsKept) {
    SmallStage stage;
    stage.scene.spotLights[0] = makeSpot({0, 3, 12}, {0, 0, 0}, 0.2);
    EXPECT_EQ(stage.line(), "shadow_map[1] forward beams[1] tonemap");
}

TEST(FramePlanLine, WhatIsScaledToNothingIsNotDrawn) {
    SmallStage stage;
    // Its draw stays in the list, so that the numbers of the others do not change with it.
    stage.scene.nodes[std::size_t(stage.floor)].worldFromLocal = glm::dmat4(0.0);
    stage.scene.nodes[std::size_t(stage.floor)].worldFromLocal[3][3] = 1.0;
    EXPECT_EQ(stage.plan().draws.size(), 1U);
    EXPECT_FALSE(stage.plan().forward.has_value());
}

TEST(FramePlanLine, ALampWithoutCastersHasNoShadowMap) {
    SmallStage stage;
    stage.scene.spotLights[0] = makeSpot({0, 1, 0}, {0, 5, 0}, 0.3);
    EXPECT_EQ(stage.line(), "forward beams[1] tonemap");
    EXPECT_EQ(stage.plan().lamps.at(0).shadowLayer, -1);
    EXPECT_EQ(stage.plan().shadowMaps.layers, 0);
    stage.settings.haze.scatteringPerMetre = 0.0;
    EXPECT_EQ(stage.line(), "forward tonemap");
    EXPECT_EQ(stage.plan().lampsSkipped, 1);
}

TEST(FramePlanLine, BeamsWithoutGeometry) {
    SmallStage stage(false, true);
    EXPECT_EQ(stage.line(), "beams[1] tonemap");
    stage.settings.haze.scatteringPerMetre = 0.0;
    EXPECT_EQ(stage.line(), "tonemap");
}

TEST(FramePlanLine, ExposureIsLookedForOnlyWhereItIsNotGiven) {
    SmallStage stage(false, false);
    EXPECT_EQ(stage.line(), "tonemap");
    stage.settings.ev100.reset();
    EXPECT_EQ(stage.line(), "exposure tonemap");
}

TEST(FramePlanLine, WithoutAScreenThereIsNoToneMapping) {
    SmallStage stage;
    stage.settings.display = false;
    EXPECT_EQ(stage.line(), "shadow_map[1] forward beams[1]");
    SmallStage empty(false, false);
    empty.settings.display = false;
    EXPECT_EQ(empty.line(), "nothing");
}

TEST(FramePlanLine, PlanesAreSaid) {
    SmallStage stage;
    stage.settings.beams.method = BeamMethod::kPlanes;
    EXPECT_EQ(stage.line(), "shadow_map[1] forward beams_planes[1] tonemap");
    EXPECT_TRUE(stage.plan().beams->tiles.tiles.empty());
}

TEST(FramePlan, PlanesRunFromTheNearPlaneToTheEndOfTheScene) {
    SmallStage stage;
    stage.camera = makeCamera({0, 1, 20}, {0, 1, 0});
    stage.settings.beams.method = BeamMethod::kPlanes;
    stage.settings.beams.planes = 100;
    // The floor's far edge is at z = -5: 25 m from the camera, along its axis.
    FramePlan plan = stage.plan();
    EXPECT_DOUBLE_EQ(plan.beams->firstDepth, stage.camera.nearMetres);
    EXPECT_NEAR(plan.beams->spacingMetres, (25.0 - stage.camera.nearMetres) / 100.0, 1e-9);
    // A given spacing puts them around the middle of that range, but none before the near plane.
    stage.settings.beams.spacingMetres = 0.07;
    plan = stage.plan();
    EXPECT_DOUBLE_EQ(plan.beams->spacingMetres, 0.07);
    EXPECT_NEAR(plan.beams->firstDepth + 0.5 * 7.0, 0.5 * (stage.camera.nearMetres + 25.0), 1e-9);
    stage.settings.beams.spacingMetres = 0.5;
    EXPECT_DOUBLE_EQ(stage.plan().beams->firstDepth, stage.camera.nearMetres);
    stage.settings.beams.spacingMetres.reset();
    stage.camera.farMetres = 10.0;
    EXPECT_NEAR(stage.plan().beams->spacingMetres, (10.0 - stage.camera.nearMetres) / 100.0, 1e-9);
}

TEST(FramePlan, BlendedShapesAndLinesCastNoShadow) {
    SmallStage stage;
    stage.scene.materials[0].alphaMode = Material::AlphaMode::kBlend;
    EXPECT_EQ(stage.line(), "forward beams[1] tonemap");
    EXPECT_EQ(stage.plan().forward->blended.size(), 1U);
    stage.scene.materials[0].alphaMode = Material::AlphaMode::kMask;
    EXPECT_EQ(stage.line(), "shadow_map[1] forward beams[1] tonemap");
    stage.scene.meshes[0].primitives[0].topology = Topology::kLines;
    EXPECT_EQ(stage.line(), "forward beams[1] tonemap");
}

TEST(FramePlan, OpaqueShapesComeNearToFarAndBlendedOnesFarToNear) {
    SmallStage stage(false, false);
    stage.camera = makeCamera({0, 0, 10}, {0, 0, 0});
    for (const float z : {0.0F, 4.0F, -6.0F}) {
        addShape(stage.scene, makeQuad({0, 0, z}, {1, 0, 0}, {0, 1, 0}),
                 makeMaterial(glm::vec3(0.5F)));
        Material glass = makeMaterial(glm::vec3(0.5F));
        glass.alphaMode = Material::AlphaMode::kBlend;
        addShape(stage.scene, makeQuad({0, 0, z - 1.0F}, {1, 0, 0}, {0, 1, 0}), glass);
    }
    const FramePlan plan = stage.plan();
    EXPECT_EQ(plan.forward->opaque, (std::vector<int>{2, 0, 4}));
    EXPECT_EQ(plan.forward->blended, (std::vector<int>{5, 1, 3}));
}

TEST(FramePlan, PointAndDirectionalLampsThatCannotReachAreSkipped) {
    SmallStage stage(true, false);
    PointLight lamp;
    lamp.position = {0, 3, 0};
    stage.scene.pointLights.push_back(lamp);
    lamp.rangeMetres = 2.9;
    stage.scene.pointLights.push_back(lamp);
    lamp.rangeMetres = 3.1;
    stage.scene.pointLights.push_back(lamp);
    lamp.intensityCandela = 0.0;
    stage.scene.pointLights.push_back(lamp);
    DirectionalLight sun;
    stage.scene.directionalLights.push_back(sun);
    sun.color = glm::vec3(0.0F);
    stage.scene.directionalLights.push_back(sun);
    const FramePlan plan = stage.plan();
    EXPECT_EQ(plan.pointLights, (std::vector<int>{0, 2}));
    EXPECT_EQ(plan.directionalLights, std::vector<int>{0});
    EXPECT_EQ(plan.lampsSkipped, 3);

    stage.camera = makeCamera({0, 2, 8}, {0, 2, 20});
    const FramePlan away = stage.plan();
    EXPECT_EQ(away.describe(), "tonemap") << "nothing in view";
    EXPECT_EQ(away.lampsSkipped, 6);
}

TEST(FramePlan, BeamSamplesCountsThePixelsOfTheTiles) {
    // The camera stands in a wide beam and looks along it: every pixel sees it.
    SmallStage stage(false, false);
    stage.scene.spotLights.push_back(makeSpot({0, 0, 0}, {0, 0, -1}, 1.2));
    stage.scene.spotLights.push_back(makeSpot({0, 0, 0.1}, {0, 0, -1}, 1.2));
    stage.camera = makeCamera({0, 0, -2}, {0, 0, -3}, 0.5);
    stage.settings.width = 70;  // no whole number of tiles
    stage.settings.height = 37;
    stage.settings.beams.planes = 24;
    EXPECT_EQ(stage.plan().beamSamples(), 24U * 2U * 70U * 37U);
    stage.settings.beams.method = BeamMethod::kPlanes;
    EXPECT_EQ(stage.plan().beamSamples(), 24U * 2U * 70U * 37U);
    stage.settings.haze.scatteringPerMetre = 0.0;
    EXPECT_EQ(stage.plan().beamSamples(), 0U);

    // A small beam: more than its own pixels, far fewer than the picture's.
    SmallStage small(false, false);
    small.scene.spotLights.push_back(makeSpot({0, 0, 0}, {0, -1, 0}, 0.1));
    small.scene.spotLights[0].rangeMetres = 0.5;
    small.camera = makeCamera({0, 0, 10}, {0, 0, 0});
    small.settings.width = 320;
    small.settings.height = 320;
    small.settings.beams.planes = 10;
    EXPECT_GT(small.plan().beamSamples(), 0U);
    EXPECT_LE(small.plan().beamSamples(), 10U * 6U * 256U);
}

}  // namespace
}  // namespace ribalta::test
