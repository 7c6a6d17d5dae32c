// Values between keys against closed forms and numbers found by hand, and scenes that are posed.
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "base/angles.h"
#include "scene/scene.h"

namespace ribalta {
namespace {

using Interpolation = AnimationSampler::Interpolation;
using Part = AnimationChannel::Part;

AnimationSampler sampler(Interpolation interpolation, std::vector<float> seconds,
                         std::vector<glm::vec4> values) {
    return {interpolation, std::move(seconds), std::move(values)};
}

glm::vec4 turn(const glm::dvec3& axis, double angle) {
    return {glm::vec3(std::sin(0.5 * angle) * glm::normalize(axis)), float(std::cos(0.5 * angle))};
}

// The angle and axis of a rotation say all of it, whatever its sign.
void expectTurn(const glm::dquat& rotation, const glm::dvec3& axis, double angle,
                double tolerance) {
    const glm::dvec3 probe = glm::normalize(glm::dvec3(0.3, -0.8, 0.5));
    const glm::dvec3 n = glm::normalize(axis);
    // Rodrigues' formula.
    const glm::dvec3 expected = std::cos(angle) * probe + std::sin(angle) * glm::cross(n, probe) +
                                (1.0 - std::cos(angle)) * glm::dot(n, probe) * n;
    EXPECT_NEAR(glm::length(rotation), 1.0, 1e-12);
    EXPECT_NEAR(glm::distance(rotation * probe, expected), 0.0, tolerance);
}

TEST(AnimationSamplerTest, LinearIsALineBetweenKeys) {
    const AnimationSampler line = sampler(Interpolation::kLinear, {1.0F, 3.0F, 4.0F},
                                          {{0, 10, -1, 0}, {4, 20, -1, 0}, {4, 0, 7, 0}});
    for (const double share : {0.0, 0.25, 0.5, 0.9}) {
        const glm::dvec3 first(sampleVector(line, 1.0 + 2.0 * share));
        EXPECT_NEAR(glm::distance(first, {4.0 * share, 10.0 + 10.0 * share, -1.0}), 0.0, 1e-12);
        const glm::dvec3 second(sampleVector(line, 3.0 + share));
        EXPECT_NEAR(glm::distance(second, {4.0, 20.0 - 20.0 * share, -1.0 + 8.0 * share}), 0.0,
                    1e-12);
    }
}

TEST(AnimationSamplerTest, StepHoldsUntilTheNextKey) {
    const AnimationSampler steps =
        sampler(Interpolation::kStep, {1.0F, 2.0F}, {{5, 0, 0, 0}, {6, 0, 0, 0}});
    EXPECT_EQ(sampleVector(steps, 1.0).x, 5.0);
    EXPECT_EQ(sampleVector(steps, std::nextafter(2.0, 0.0)).x, 5.0);
    EXPECT_EQ(sampleVector(steps, 2.0).x, 6.0);
}

TEST(AnimationSamplerTest, NothingChangesBeforeTheFirstAndAfterTheLastKey) {
    for (const Interpolation way : {Interpolation::kStep, Interpolation::kLinear}) {
        const AnimationSampler keys = sampler(way, {1.0F, 2.0F}, {{5, 1, 2, 0}, {6, 3, 4, 0}});
        EXPECT_EQ(glm::dvec3(sampleVector(keys, -7.0)), glm::dvec3(5, 1, 2));
        EXPECT_EQ(glm::dvec3(sampleVector(keys, 0.999)), glm::dvec3(5, 1, 2));
        EXPECT_EQ(glm::dvec3(sampleVector(keys, 1e30)), glm::dvec3(6, 3, 4));
    }
    // Tangents would carry on; the file's times do not.
    const AnimationSampler curve = sampler(
        Interpolation::kCubicSpline, {1.0F, 2.0F},
        {{9, 9, 9, 0}, {5, 1, 2, 0}, {9, 9, 9, 0}, {9, 9, 9, 0}, {6, 3, 4, 0}, {9, 9, 9, 0}});
    EXPECT_EQ(glm::dvec3(sampleVector(curve, 0.0)), glm::dvec3(5, 1, 2));
    EXPECT_EQ(glm::dvec3(sampleVector(curve, 2.0)), glm::dvec3(6, 3, 4));
    EXPECT_EQ(glm::dvec3(sampleVector(curve, 3.0)), glm::dvec3(6, 3, 4));
}

TEST(AnimationSamplerTest, OneKeyIsAllThereIs) {
    EXPECT_EQ(sampleVector(sampler(Interpolation::kLinear, {4.0F}, {{1, 2, 3, 0}}), 9.0).y, 2.0);
    const AnimationSampler curve =
        sampler(Interpolation::kCubicSpline, {4.0F}, {{7, 7, 7, 0}, {1, 2, 3, 0}, {7, 7, 7, 0}});
    EXPECT_EQ(sampleVector(curve, 0.0).z, 3.0);
    EXPECT_EQ(sampleVector(curve, 9.0).z, 3.0);
}

TEST(AnimationSamplerTest, EveryKeyIsMet) {
    std::mt19937 random(3);  // NOLINT(cert-msc51-cpp): the same keys in every run
    std::uniform_real_distribution<float> any(0.01F, 1.0F);
    std::vector<float> seconds;
    std::vector<glm::vec4> values;
    float time = 0.0F;
    for (int i = 0; i < 1000; ++i) {
        time += any(random);
        seconds.push_back(time);
        values.emplace_back(any(random), any(random), any(random), 0.0F);
    }
    const AnimationSampler keys = sampler(Interpolation::kLinear, seconds, values);
    for (std::size_t i = 0; i < seconds.size(); ++i) {
        EXPECT_EQ(glm::vec3(sampleVector(keys, double(seconds[i]))), glm::vec3(values[i]));
    }
}

// A cubic is its own Hermite spline: keys and tangents of p(t) give p(t) back between them, however
// far apart they stand.
TEST(AnimationSamplerTest, SplineOfACubicIsTheCubic) {
    const auto p = [](double t) { return ((0.5 * t - 2.0) * t + 1.0) * t + 3.0; };
    const auto slope = [](double t) { return (1.5 * t - 4.0) * t + 1.0; };
    AnimationSampler curve{Interpolation::kCubicSpline, {0.5F, 0.75F, 4.0F}, {}};
    for (const float t : curve.seconds) {
        const auto tangent = glm::vec4(static_cast<float>(slope(double(t))));
        const auto value = glm::vec4(static_cast<float>(p(double(t))));
        for (const glm::vec4& each : {tangent, value, tangent}) {
            curve.values.push_back(each);
        }
    }
    for (double t = 0.5; t <= 4.0; t += 0.0625) {
        EXPECT_NEAR(sampleVector(curve, t).x, p(t), 1e-6) << t;
    }
}

// By hand: between 0 at 1 s with the tangent 3 out of it and 10 at 3 s with the tangent -1 into it,
// halfway: 0.5 * 0 + 2 * 0.125 * 3 + 0.5 * 10 - 2 * 0.125 * -1 = 6.
TEST(AnimationSamplerTest, SplineByHand) {
    const AnimationSampler curve = sampler(
        Interpolation::kCubicSpline, {1.0F, 3.0F},
        {glm::vec4(77), glm::vec4(0), glm::vec4(3), glm::vec4(-1), glm::vec4(10), glm::vec4(77)});
    EXPECT_NEAR(sampleVector(curve, 2.0).x, 6.0, 1e-12);
}

TEST(AnimationSamplerTest, RotationTurnsAtAnEvenPace) {
    const glm::dvec3 axis(1.0, 2.0, -0.5);
    for (const double angle : {1e-9, 1e-4, 0.1, 1.0, 3.0}) {
        const AnimationSampler keys = sampler(Interpolation::kLinear, {0.0F, 2.0F},
                                              {turn(axis, 0.25), turn(axis, 0.25 + angle)});
        for (const double share : {0.0, 0.125, 0.5, 0.7, 1.0}) {
            expectTurn(sampleRotation(keys, 2.0 * share), axis, 0.25 + share * angle, 2e-7);
        }
    }
}

TEST(AnimationSamplerTest, RotationTakesTheShorterWay) {
    const glm::dvec3 axis(0.0, 1.0, 0.0);
    // The same end, written with the other sign, as an angle of 350 degrees does.
    const glm::vec4 end = -turn(axis, 0.2);
    const AnimationSampler keys =
        sampler(Interpolation::kLinear, {0.0F, 1.0F}, {turn(axis, 0.0), end});
    expectTurn(sampleRotation(keys, 0.5), axis, 0.1, 1e-7);
    const AnimationSampler wide = sampler(Interpolation::kLinear, {0.0F, 1.0F},
                                          {turn(axis, 0.0), turn(axis, 350.0 / 180.0 * kPi)});
    expectTurn(sampleRotation(wide, 0.5), axis, -5.0 / 180.0 * kPi, 1e-7);
}

TEST(AnimationSamplerTest, RotationsAreOfAnyLength) {
    const glm::dvec3 axis(0.0, 0.0, 1.0);
    const AnimationSampler keys = sampler(Interpolation::kLinear, {0.0F, 1.0F},
                                          {7.0F * turn(axis, 0.0), 0.01F * turn(axis, 1.0)});
    expectTurn(sampleRotation(keys, 0.5), axis, 0.5, 1e-7);
    const AnimationSampler steps = sampler(Interpolation::kStep, {0.0F, 1.0F}, keys.values);
    expectTurn(sampleRotation(steps, 0.5), axis, 0.0, 1e-7);
}

// By hand: from (0, 0, 0, 1) to (0, 0, 1, 0) without tangents, halfway (0, 0, 0.5, 0.5), which is a
// quarter turn about z.
TEST(AnimationSamplerTest, SplineOfRotationsIsBroughtToUnitLength) {
    const glm::vec4 none(0);
    const AnimationSampler curve = sampler(Interpolation::kCubicSpline, {0.0F, 4.0F},
                                           {none, {0, 0, 0, 1}, none, none, {0, 0, 1, 0}, none});
    expectTurn(sampleRotation(curve, 2.0), {0, 0, 1}, 0.5 * kPi, 1e-12);
    // Through the origin: no direction, and yet a rotation.
    const AnimationSampler through = sampler(Interpolation::kCubicSpline, {0.0F, 4.0F},
                                             {none, {0, 0, 0, 1}, none, none, {0, 0, 0, -1}, none});
    expectTurn(sampleRotation(through, 2.0), {0, 0, 1}, 0.0, 1e-12);
}

/// An arm 2 m out on a mast 6 m high, a lamp on the arm, and a mast that two animations move.
class PosedScene : public testing::Test {
  protected:
    PosedScene() {
        Mover mast{0, {{0.0, 6.0, 0.0}, glm::dquat(1, 0, 0, 0), glm::dvec3(1.0)}, {}};
        Mover arm{1, {{2.0, 0.0, 0.0}, glm::dquat(1, 0, 0, 0), glm::dvec3(3.0)}, {}};
        for (Mover* mover : {&mast, &arm}) {
            mover->pose = mover->rest;
            Node& node = scene_.nodes.emplace_back();
            node.parent = mover->node - 1;
            node.parentFromLocal = mover->rest.parentFromLocal();
            scene_.movers.push_back(*mover);
        }
        scene_.spotLights.emplace_back().node = 1;
        scene_.animations.push_back({"turn",
                                     {sampler(Interpolation::kLinear, {0.0F, 1.0F},
                                              {turn({0, 1, 0}, 0.0), turn({0, 1, 0}, 0.5 * kPi)})},
                                     {{0, 0, Part::kRotation}}});
        scene_.animations.push_back(
            {"rise",
             {sampler(Interpolation::kLinear, {0.0F, 4.0F}, {{0, 0, 0, 0}, {0, 8, 0, 0}}),
              sampler(Interpolation::kStep, {0.0F}, {turn({1, 0, 0}, 1.0)})},
             {{0, 0, Part::kTranslation}, {0, 1, Part::kRotation}}});
        scene_.animations.push_back(
            {"grow",
             {sampler(Interpolation::kLinear, {1.0F, 2.0F}, {{1, 1, 1, 0}, {2, 2, 2, 0}})},
             {{1, 0, Part::kScale}}});
        placeNodes(scene_);
    }

    glm::dvec3 lamp() const { return scene_.spotLights[0].frame.position; }
    double armLength() const { return glm::length(glm::dvec3(scene_.nodes[1].worldFromLocal[0])); }

    Scene scene_;
};

TEST_F(PosedScene, AllTogetherOnOneTimeline) {
    // After half a second: an eighth of a turn, the mast at 1 m; the arm's growth has not begun.
    poseScene(scene_, 0.5);
    const double half = std::sqrt(0.5);
    EXPECT_NEAR(glm::distance(lamp(), {2.0 * half, 1.0, -2.0 * half}), 0.0, 1e-6);
    EXPECT_NEAR(armLength(), 1.0, 1e-12);
    // After three: the turn is over, the mast at 6 m, the arm twice as long.
    poseScene(scene_, 3.0);
    EXPECT_NEAR(glm::distance(lamp(), {0.0, 6.0, -2.0}), 0.0, 1e-6);
    EXPECT_NEAR(armLength(), 2.0, 1e-12);
}

TEST_F(PosedScene, OneAloneLeavesTheOthersAtRest) {
    poseScene(scene_, 3.0);
    poseScene(scene_, 0.5, 0);
    const double half = std::sqrt(0.5);
    EXPECT_NEAR(glm::distance(lamp(), {2.0 * half, 6.0, -2.0 * half}), 0.0, 1e-6);
    EXPECT_NEAR(armLength(), 3.0, 1e-12);
}

TEST_F(PosedScene, TheFirstOfTwoThatMoveOnePartIsSeen) {
    poseScene(scene_, 0.0);
    EXPECT_EQ(scene_.movers[0].pose.rotation, glm::dquat(1, 0, 0, 0));
    poseScene(scene_, 0.0, 1);
    EXPECT_NEAR(scene_.movers[0].pose.rotation.x, std::sin(0.5), 1e-7);
}

TEST_F(PosedScene, RestIsToTheLastBitWhatItWas) {
    const Scene before = scene_;
    poseScene(scene_, 2.5);
    ASSERT_NE(scene_.nodes[0].worldFromLocal, before.nodes[0].worldFromLocal);
    restScene(scene_);
    for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
        EXPECT_EQ(scene_.nodes[i].parentFromLocal, before.nodes[i].parentFromLocal);
        EXPECT_EQ(scene_.nodes[i].worldFromLocal, before.nodes[i].worldFromLocal);
    }
    EXPECT_EQ(scene_.spotLights, before.spotLights);
}

TEST_F(PosedScene, PosesDoNotDependOnTheOnesBefore) {
    Scene other = scene_;
    poseScene(scene_, 0.1);
    poseScene(scene_, 3.7, 2);
    poseScene(scene_, 1.3);
    poseScene(other, 1.3);
    EXPECT_EQ(scene_.nodes[1].worldFromLocal, other.nodes[1].worldFromLocal);
}

TEST_F(PosedScene, DurationIsTheLastKey) {
    EXPECT_EQ(durationSeconds(scene_), 4.0);
    EXPECT_EQ(durationSeconds(scene_, 0), 1.0);
    EXPECT_EQ(durationSeconds(scene_, 2), 2.0);
    EXPECT_EQ(durationSeconds(Scene()), 0.0);
}

TEST(Vanishing, LessThanAPlaneIsLeft) {
    const auto scaled = [](double x, double y, double z) {
        Pose pose;
        pose.scale = {x, y, z};
        return pose.parentFromLocal();
    };
    EXPECT_TRUE(vanishes(scaled(0, 0, 0)));
    EXPECT_TRUE(vanishes(scaled(1, 0, 0)));
    EXPECT_FALSE(vanishes(scaled(1, 1, 0)));
    EXPECT_FALSE(vanishes(scaled(1e-6, 1e-6, 1e-6)));
}

}  // namespace
}  // namespace ribalta
