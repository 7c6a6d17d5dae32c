// Which maps the sun's shadows need: that what is seen lies in one, that all that casts into it is
// drawn, and that nothing is made in vain.
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "base/angles.h"
#include "render/frame_plan.h"
#include "support/stage.h"

namespace ribalta::test {
namespace {

glm::dvec3 sunAt(double elevation, double around = 0.7) {
    return {std::cos(elevation * kDegree) * std::cos(around), std::sin(elevation * kDegree),
            std::cos(elevation * kDegree) * std::sin(around)};
}

class PlanSunShadow : public testing::Test {
  protected:
    PlanSunShadow() {
        addShape(scene_, makeQuad({0, 0, 0}, {300, 0, 0}, {0, 0, -300}),
                 makeMaterial(glm::vec3(0.5F)));
        for (const float x : {-90.0F, -4.0F, 0.0F, 5.0F, 60.0F}) {
            boxes_.push_back(addShape(scene_, makeBox({x, 0, -1}, {x + 1, 6, 1}),
                                      makeMaterial(glm::vec3(0.5F))));
        }
        settings_.width = 320;
        settings_.height = 240;
        settings_.display = false;
        settings_.haze.scatteringPerMetre = 0.0;
        settings_.sky.emplace();
        settings_.sky->towardsSun = sunAt(35.0);
    }
    FramePlan next() {
        FramePlan plan = planFrame(scene_, camera_, settings_, cache_);
        keepForNextFrame(scene_, plan, cache_);
        return plan;
    }
    /// Maps drawn; -1 without any shadows.
    int drawn() {
        const FramePlan plan = next();
        return plan.sunShadow ? plan.sunShadow->drawn() : -1;
    }

    Scene scene_;
    Camera camera_ = makeCamera({0, 2, 12}, {0, 1, 0}, 1.0);
    FrameSettings settings_;
    FrameCache cache_;
    std::vector<int> boxes_;
};

/// From the cascade's middle in the sun's frame.
glm::dvec3 placeIn(const SunShadowWork& work, const SunCascade& cascade, const glm::dvec3& point) {
    return work.sunFromWorld * point - cascade.middle;
}

bool holds(const SunShadowWork& work, const SunCascade& cascade, const glm::dvec3& point) {
    const glm::dvec3 place = placeIn(work, cascade, point);
    const double room = cascade.halfSide - kSunMapMargin * work.texelMetres(cascade);
    return std::max(std::abs(place.x), std::abs(place.y)) < room &&
           place.z > kSunMapMargin * work.texelMetres(cascade);
}

bool rayMeets(const Bounds& box, const glm::dvec3& from, const glm::dvec3& direction) {
    double first = 0.0;
    double last = 1e9;
    for (int i = 0; i < 3; ++i) {
        const double a = (box.low[i] - from[i]) / direction[i];
        const double b = (box.high[i] - from[i]) / direction[i];
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    return first <= last;
}

TEST_F(PlanSunShadow, WhatIsSeenLiesInACascadeWithAllThatShadesIt) {
    std::mt19937 engine(5);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine);
    };
    int points = 0;
    int shaded = 0;
    for (int trial = 0; trial < 60; ++trial) {
        camera_ = makeCamera({between(-40, 40), between(0.5, 30), between(-40, 40)},
                             {between(-10, 10), 0, between(-10, 10)}, between(0.3, 1.5));
        if (trial % 5 == 4) {
            camera_.lens = OrthographicLens{8.0, 6.0};
            camera_.farMetres = 200.0;
        }
        settings_.sky->towardsSun = sunAt(between(1.0, 90.0), between(0.0, 6.0));
        const FramePlan plan = planFrame(scene_, camera_, settings_, {});
        ASSERT_TRUE(plan.sunShadow.has_value());
        const SunShadowWork& work = *plan.sunShadow;
        const glm::dmat4 clip = clipFromWorld(camera_, settings_.width, settings_.height);
        for (int i = 0; i < 400; ++i) {
            // On the floor, most of them near.
            const double far = std::exp(between(0.0, std::log(300.0)));
            const double around = between(0.0, 2.0 * std::numbers::pi);
            const glm::dvec3 point(far * std::cos(around), 0.0, far * std::sin(around));
            const glm::dvec4 seen = clip * glm::dvec4(point, 1.0);
            if (!(seen.w > 0.0) || std::abs(seen.x) > seen.w || std::abs(seen.y) > seen.w ||
                seen.z < 0.0 || seen.z > seen.w) {
                continue;
            }
            ++points;
            const SunCascade* holding = nullptr;
            for (const SunCascade& cascade : work.cascades) {
                if (holds(work, cascade, point)) {
                    holding = holding == nullptr ? &cascade : holding;
                }
            }
            ASSERT_NE(holding, nullptr) << point.x << ", " << point.z;
            for (std::size_t d = 0; d < plan.draws.size(); ++d) {
                const Bounds& box = plan.draws[d].worldBounds;
                if (rayMeets(box, point, settings_.sky->towardsSun)) {
                    ++shaded;
                    const auto& casters = holding->casters;
                    EXPECT_NE(std::find(casters.begin(), casters.end(), int(d)), casters.end());
                    for (int corner = 0; corner < 8; ++corner) {
                        EXPECT_LT(placeIn(work, *holding, box.corner(corner)).z,
                                  holding->topMetres);
                    }
                }
            }
        }
    }
    EXPECT_GT(points, 2000);
    EXPECT_GT(shaded, points);
}

TEST_F(PlanSunShadow, NearCascadesAreFinerAndCullWhatStandsElsewhere) {
    const FramePlan plan = next();
    const SunShadowWork& work = *plan.sunShadow;
    ASSERT_GE(work.cascades.size(), 3U);
    for (std::size_t i = 1; i < work.cascades.size(); ++i) {
        EXPECT_GT(work.cascades[i].halfSide, 1.5 * work.cascades[i - 1].halfSide);
    }
    EXPECT_GT(work.castersCulled, 0);
    EXPECT_LT(work.cascades.front().casters.size(), work.cascades.back().casters.size());
    // At the middle of the picture a texel is no wider than a few pixels.
    const double pixel = 2.0 * std::tan(0.5) / settings_.height * 12.0;
    EXPECT_LT(work.texelMetres(work.cascades.front()), 4.0 * pixel);
}

TEST_F(PlanSunShadow, NothingIsMadeInVain) {
    EXPECT_GT(drawn(), 0);
    EXPECT_NE(next().describe().find("forward"), std::string::npos);
    FrameSettings sunny = settings_;
    settings_.sky->towardsSun = sunAt(-0.3);
    EXPECT_EQ(drawn(), -1) << "down";
    EXPECT_EQ(next().describe().find("sun_shadow"), std::string::npos);
    settings_.sky->towardsSun = sunAt(-0.2);
    EXPECT_GT(drawn(), 0) << "its upper edge is up";
    settings_.sky->towardsSun = sunAt(-2.0);
    settings_.sky->altitudeMetres = 10e3;
    EXPECT_GT(drawn(), 0) << "still up at that height";
    settings_ = sunny;
    settings_.sky->air.sunIlluminanceLux = glm::dvec3(0.0);
    EXPECT_EQ(drawn(), -1) << "dark";
    settings_ = sunny;
    settings_.sky.reset();
    EXPECT_EQ(drawn(), -1) << "no sky";
    settings_ = sunny;
    camera_ = makeCamera({0, 2, 12}, {0, 900, 12.1}, 0.5);
    EXPECT_EQ(drawn(), -1) << "nothing in view";
    camera_ = makeCamera({0, 2, 12}, {0, 1, 0}, 1.0);
    for (Material& material : scene_.materials) {
        material.alphaMode = Material::AlphaMode::kBlend;
    }
    EXPECT_EQ(drawn(), -1) << "nothing that casts";
}

TEST_F(PlanSunShadow, MapsAreKeptWhileNothingTheyDependOnChanges) {
    const int all = drawn();
    EXPECT_EQ(drawn(), 0);
    FramePlan plan = next();
    EXPECT_EQ(plan.describe().find("sun_shadow"), std::string::npos);
    EXPECT_EQ(int(plan.sunShadow->cascades.size()), all);
    // The air, the lamps, the exposure are nothing to them.
    settings_.sky->orders = {1, false};
    settings_.ambientLux = 7.0;
    EXPECT_EQ(drawn(), 0);
    // A box that only the farther ones see.
    moveNode(scene_, boxes_[0], {0.1, 0, 0});
    const int redrawn = drawn();
    EXPECT_GT(redrawn, 0);
    EXPECT_LT(redrawn, all);
    settings_.sky->towardsSun = sunAt(36.0);
    EXPECT_EQ(drawn(), all);
    settings_.height *= 4;
    settings_.width *= 4;
    plan = next();
    EXPECT_EQ(plan.sunShadow->drawn(), int(plan.sunShadow->cascades.size())) << "finer maps";
}

TEST_F(PlanSunShadow, TexelsStandStillWhileTheCameraMoves) {
    const SunShadowWork before = *next().sunShadow;
    for (const double step : {0.013, 0.4, 1.7}) {
        camera_ = makeCamera({step, 2.0 + 0.1 * step, 12}, {step, 1, 0}, 1.0);
        const SunShadowWork after = *next().sunShadow;
        for (std::size_t i = 0; i < std::min(before.cascades.size(), after.cascades.size()); ++i) {
            ASSERT_EQ(after.cascades[i].halfSide, before.cascades[i].halfSide) << i;
            const glm::dvec3 texels = (after.cascades[i].middle - before.cascades[i].middle) /
                                      before.texelMetres(before.cascades[i]);
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(texels[c], std::round(texels[c]), 1e-6) << i;
            }
        }
    }
}

TEST_F(PlanSunShadow, ASmallSceneNeedsOneMap) {
    scene_.nodes.resize(1);
    scene_.nodes.push_back({});
    addShape(scene_, makeBox({-1, 0, -1}, {1, 2, 1}), makeMaterial(glm::vec3(0.5F)));
    scene_.nodes[0].mesh = -1;
    EXPECT_EQ(drawn(), 1);
}

}  // namespace
}  // namespace ribalta::test
