// Which shadow maps a frame draws and which it keeps from the frame before.
#include <set>

#include <gtest/gtest.h>

#include "render/frame_plan.h"
#include "support/stage.h"

namespace ribalta::test {
namespace {

/// Two towers under a lamp each, which cannot see the other's; frames are planned one after
/// another.
class ShadowPlan : public testing::Test {
  protected:
    ShadowPlan() {
        for (const float x : {-3.0F, 3.0F}) {
            towers_.push_back(addShape(scene_, makeBox({x - 0.5F, 0, -0.5F}, {x + 0.5F, 1, 0.5F}),
                                       makeMaterial(glm::vec3(0.5F))));
            scene_.spotLights.push_back(makeSpot({x, 5, 0}, {x, 0, 0}, 0.2));
        }
        settings_.width = 64;
        settings_.height = 48;
        settings_.ev100 = 5.0;
        settings_.beams.planes = kSheetsForPyramid - 1;
    }

    FramePlan next() {
        FramePlan plan = planFrame(scene_, camera_, settings_, cache_);
        keepForNextFrame(scene_, plan, cache_);
        return plan;
    }
    /// A frame of which `drawn` maps are drawn and the others kept; every lamp has a layer of its
    /// own.
    void expectDrawn(const std::set<int>& drawn, const std::string& why) {
        const FramePlan plan = next();
        std::set<int> spots;
        std::set<int> layers;
        for (const ShadowMapWork& work : plan.shadowMapWork) {
            spots.insert(work.spot);
        }
        for (const PlannedLamp& lamp : plan.lamps) {
            EXPECT_GE(lamp.shadowLayer, 0) << why;
            EXPECT_LT(lamp.shadowLayer, plan.shadowMaps.layers) << why;
            EXPECT_TRUE(layers.insert(lamp.shadowLayer).second) << why;
        }
        EXPECT_EQ(spots, drawn) << why;
        EXPECT_EQ(plan.shadowMapsKept, int(plan.lamps.size() - drawn.size())) << why;
    }

    Scene scene_;
    Camera camera_ = makeCamera({0, 3, 12}, {0, 1, 0}, 1.0);
    FrameSettings settings_;
    FrameCache cache_;
    std::vector<int> towers_;
};

TEST_F(ShadowPlan, APyramidIsMadeForManySheetsAndOfWhatItHasNotYet) {
    EXPECT_EQ(next().describe(), "shadow_map[2] forward beams[2] tonemap") << "too few sheets";
    settings_.beams.planes = kSheetsForPyramid;
    FramePlan plan = next();
    EXPECT_EQ(plan.describe(), "shadow_pyramid[2] forward beams[2] tonemap") << "of kept maps";
    EXPECT_TRUE(plan.beams->shadowPyramid);
    plan = next();
    EXPECT_EQ(plan.describe(), "forward beams[2] tonemap");
    EXPECT_TRUE(plan.beams->shadowPyramid);
    moveNode(scene_, towers_[0], {0.1, 0, 0});
    plan = next();
    EXPECT_EQ(plan.describe(), "shadow_map[1] shadow_pyramid[1] forward beams[2] tonemap");
    EXPECT_EQ(plan.shadowPyramidWork.front(), plan.shadowMapWork.front().layer);
    // A map that is drawn while the pyramid is not used leaves the pyramid behind.
    settings_.beams.planes = kSheetsForPyramid - 1;
    moveNode(scene_, towers_[0], {0.1, 0, 0});
    EXPECT_EQ(next().describe(), "shadow_map[1] forward beams[2] tonemap");
    settings_.beams.planes = kSheetsForPyramid;
    EXPECT_EQ(next().describe(), "shadow_pyramid[1] forward beams[2] tonemap");
    // The baselines never have one, nor have lamps without casters.
    for (const auto method : {BeamMethod::kMarch, BeamMethod::kPlanes}) {
        settings_.beams.method = method;
        cache_ = {};
        EXPECT_TRUE(next().shadowPyramidWork.empty());
    }
    settings_.beams.method = BeamMethod::kClipped;
    cache_ = {};
    scene_.nodes.clear();
    plan = next();
    EXPECT_EQ(plan.describe(), "beams[2] tonemap");
    EXPECT_FALSE(plan.beams->shadowPyramid);
}

TEST_F(ShadowPlan, TheSecondFrameKeepsAll) {
    EXPECT_EQ(next().describe(), "shadow_map[2] forward beams[2] tonemap");
    const FramePlan second = next();
    EXPECT_EQ(second.describe(), "forward beams[2] tonemap");
    EXPECT_EQ(second.shadowMapsKept, 2);
    EXPECT_EQ(second.shadowMaps.layers, 2);
}

TEST_F(ShadowPlan, ACastersOwnLampAloneIsDrawnAnew) {
    const FramePlan plan = next();
    EXPECT_EQ(plan.shadowMapWork.at(0).casters, std::vector<int>{0});
    EXPECT_EQ(plan.shadowMapWork.at(1).casters, std::vector<int>{1});
    moveNode(scene_, towers_[1], {0.1, 0, 0});
    expectDrawn({1}, "moved caster");
    expectDrawn({}, "standing still");
    moveNode(scene_, towers_[0], {0, 0.2, 0});
    expectDrawn({0}, "the other caster");
}

TEST_F(ShadowPlan, ACasterThatWalksIntoABeamOrOutOfItCounts) {
    next();
    moveNode(scene_, towers_[1], {-6, 0, 0});
    const FramePlan plan = next();
    // Nothing stands in the second beam any more; two stand in the first.
    EXPECT_EQ(plan.lamps.at(1).shadowLayer, -1);
    ASSERT_EQ(plan.shadowMapWork.size(), 1U);
    EXPECT_EQ(plan.shadowMapWork[0].spot, 0);
    EXPECT_EQ(plan.shadowMapWork[0].casters, (std::vector<int>{0, 1}));
}

TEST_F(ShadowPlan, AMovedTurnedOrWidenedLampIsDrawnAnew) {
    next();
    SpotLight& lamp = scene_.spotLights[0];
    lamp.frame.position.y += 0.1;
    expectDrawn({0}, "moved");
    lamp.frame = lookAt(lamp.frame.position, {-3.1, 0, 0});
    expectDrawn({0}, "turned");
    lamp.outerConeAngle = 0.25;
    expectDrawn({0}, "widened");
}

TEST_F(ShadowPlan, WhatAShadowDoesNotDependOnKeepsTheMaps) {
    next();
    camera_ = makeCamera({1, 3, 11}, {0, 1, 0}, 1.0);
    expectDrawn({}, "another camera");
    scene_.spotLights[0].intensityCandela = 5.0;
    scene_.spotLights[1].color = {1.0F, 0.0F, 0.0F};
    expectDrawn({}, "dimmed and coloured");
    scene_.spotLights[0].innerConeAngle = 0.1;
    expectDrawn({}, "another inner cone");
    settings_.haze.scatteringPerMetre = 0.5;
    settings_.width = 80;
    expectDrawn({}, "other haze, wider picture");
}

TEST_F(ShadowPlan, ALampThatGoesOutAndComesBackFindsItsMap) {
    next();
    scene_.spotLights[0].intensityCandela = 0.0;
    expectDrawn({}, "one lamp out");
    scene_.spotLights[0].intensityCandela = 100.0;
    expectDrawn({}, "back again");
}

TEST_F(ShadowPlan, AFinerPictureDrawsAllMapsFiner) {
    const int before = next().shadowMaps.side;
    settings_.height = 8 * settings_.height + 200;
    const FramePlan plan = next();
    EXPECT_GT(plan.shadowMaps.side, before);
    EXPECT_EQ(plan.shadowMapWork.size(), 2U);
    EXPECT_EQ(plan.shadowMapsKept, 0);
}

TEST_F(ShadowPlan, AnEmptyCacheDrawsAll) {
    next();
    cache_ = {};
    expectDrawn({0, 1}, "forgotten");
}

TEST_F(ShadowPlan, ManyLampsShareTheMemory) {
    settings_.width = 3840;
    settings_.height = 2160;
    EXPECT_EQ(next().shadowMaps.side, 2048);
    for (int i = 0; i < 60; ++i) {
        scene_.spotLights.push_back(makeSpot({-3.0 + 0.01 * i, 6, 0}, {-3, 0, 0}, 0.1));
    }
    const FramePlan plan = next();
    const auto texels =
        std::int64_t(plan.shadowMaps.side) * plan.shadowMaps.side * plan.shadowMaps.layers;
    EXPECT_EQ(plan.shadowMaps.layers, 62);
    EXPECT_LE(4 * texels, std::int64_t(192) << 20) << "bytes";
    EXPECT_GE(plan.shadowMaps.side, 256);
}

}  // namespace
}  // namespace ribalta::test
