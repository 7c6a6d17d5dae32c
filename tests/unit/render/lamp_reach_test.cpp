// What a lamp can light and where its beam shows: never less than what is there, and no for what is
// clearly elsewhere.
#include "render/lamp_reach.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/angles.h"
#include "random_beams.h"
#include "support/stage.h"

namespace ribalta::test {
namespace {

/// A box of random sides that holds the point somewhere.
Bounds boxAround(RandomBeams& random, const glm::dvec3& point) {
    const double size = std::pow(10.0, random.between(-4.0, 1.5));
    Bounds box;
    box.add(point);
    for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] -= size * random.between(0.0, 1.0);
        box.high[axis] += size * random.between(0.0, 1.0);
    }
    return box;
}

Bounds boxAt(const glm::dvec3& centre, double half) {
    Bounds box;
    box.add(centre - half);
    box.add(centre + half);
    return box;
}

TEST(LampReach, BeamTouchesEveryBoxThatHoldsAPointOfIt) {
    RandomBeams random(1);
    for (int i = 0; i < 50000; ++i) {
        const SpotLight lamp = random.lamp();
        const glm::dvec3 point = random.pointInBeam(lamp, 200.0);
        ASSERT_TRUE(beamTouches(lamp, boxAround(random, point))) << "case " << i;
    }
}

TEST(LampReach, BeamMissesWhatIsClearlyElsewhere) {
    const SpotLight lamp = makeSpot({0, 0, 0}, {0, 0, -1}, 10.0 * kDegree);
    EXPECT_TRUE(beamTouches(lamp, boxAt({0, 0, -5}, 0.1)));
    EXPECT_FALSE(beamTouches(lamp, boxAt({0, 0, 5}, 0.1))) << "behind";
    EXPECT_FALSE(beamTouches(lamp, boxAt({3, 0, -5}, 0.1))) << "beside";
    EXPECT_FALSE(beamTouches(lamp, boxAt({0, -3, -5}, 0.1))) << "below";
    EXPECT_FALSE(beamTouches(lamp, boxAt({2, 2, -5}, 0.1))) << "diagonally beside";
    EXPECT_FALSE(beamTouches(lamp, Bounds())) << "nothing";

    SpotLight ranged = lamp;
    ranged.rangeMetres = 4.0;
    EXPECT_TRUE(beamTouches(ranged, boxAt({0, 0, -3.9}, 0.05)));
    EXPECT_FALSE(beamTouches(ranged, boxAt({0, 0, -5}, 0.1))) << "beyond the range";
}

TEST(LampReach, APyramidReachesIntoItsCornersAndAConeDoesNot) {
    SpotLight lamp = makeSpot({0, 0, 0}, {0, 0, -1}, 40.0 * kDegree);
    const double corner = 0.97 * std::tan(40.0 * kDegree);
    const Bounds box = boxAt(10.0 * glm::dvec3(corner, corner, -1.0), 0.05);
    EXPECT_FALSE(beamTouches(lamp, box));
    lamp.beamShape = BeamShape::kPyramid;
    EXPECT_TRUE(beamTouches(lamp, box));
}

TEST(LampReach, ViewTouchesEveryBoxThatHoldsAPointOfIt) {
    RandomBeams random(2);
    const int width = 160;
    const int height = 90;
    for (int i = 0; i < 50000; ++i) {
        const Camera camera = random.camera(random.lamp());
        const glm::dvec2 ndc(random.between(-1.0, 1.0), random.between(-1.0, 1.0));
        const double depth = random.between(camera.nearMetres, std::min(camera.farMetres, 300.0));
        const glm::dvec2 aside =
            ndc * viewHalfExtent(camera, width, height) * (camera.isOrthographic() ? 1.0 : depth);
        const glm::dvec3 point = camera.frame.position + depth * camera.frame.forward() +
                                 aside.x * camera.frame.right() + aside.y * camera.frame.up();
        ASSERT_TRUE(viewTouches(clipFromWorld(camera, width, height), boxAround(random, point)))
            << "case " << i;
    }
}

TEST(LampReach, ViewMissesWhatIsClearlyElsewhere) {
    Camera camera = makeCamera({0, 0, 0}, {0, 0, -1}, 60.0 * kDegree);
    camera.farMetres = 50.0;
    const glm::dmat4 clip = clipFromWorld(camera, 100, 100);
    EXPECT_TRUE(viewTouches(clip, boxAt({0, 0, -10}, 0.1)));
    EXPECT_FALSE(viewTouches(clip, boxAt({0, 0, 10}, 0.1))) << "behind";
    EXPECT_FALSE(viewTouches(clip, boxAt({0, 0, -0.04}, 0.01))) << "before the near plane";
    EXPECT_FALSE(viewTouches(clip, boxAt({0, 0, -60}, 1.0))) << "beyond the far plane";
    EXPECT_FALSE(viewTouches(clip, boxAt({8, 0, -10}, 0.1))) << "to the right";
    EXPECT_FALSE(viewTouches(clip, boxAt({0, -8, -10}, 0.1))) << "below";
    EXPECT_FALSE(viewTouches(clip, Bounds())) << "nothing";
}

/// How far outside a convex outline (either way round) a point is, in pixels; at most 0 inside.
double outsideBy(const std::vector<glm::dvec2>& outline, const glm::dvec2& point) {
    if (outline.size() < 3) {
        return std::numeric_limits<double>::infinity();
    }
    double area = 0.0;
    double worst = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2 a = outline[i] - point;
        const glm::dvec2 b = outline[(i + 1) % outline.size()] - point;
        area += a.x * b.y - a.y * b.x;
    }
    const double turn = area < 0.0 ? -1.0 : 1.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2 a = outline[i];
        const glm::dvec2 side = outline[(i + 1) % outline.size()] - a;
        const glm::dvec2 to = point - a;
        if (glm::length(side) > 0.0) {
            worst = std::max(worst, -turn * (side.x * to.y - side.y * to.x) / glm::length(side));
        }
    }
    return worst;
}

TEST(LampReach, OutlineHoldsEveryPointOfTheBeamBeforeTheCamera) {
    RandomBeams random(3);
    const int width = 320;
    const int height = 180;
    int shown = 0;
    for (int i = 0; i < 4000; ++i) {
        const SpotLight lamp = random.lamp();
        const Camera camera = random.camera(lamp);
        const std::vector<glm::dvec2> outline = beamOutline(lamp, camera, width, height);
        for (int p = 0; p < 25; ++p) {
            const glm::dvec3 point = random.pointInBeam(lamp, 1000.0);
            const std::optional<glm::dvec2> pixel = project(camera, width, height, point);
            // Only what may fall into the picture matters; far outside it rounding grows with the
            // distance.
            if (!pixel || glm::length(*pixel) > 1e4) {
                continue;
            }
            ++shown;
            // Tiles are taken half a pixel larger than the outline: a hundredth is nothing.
            ASSERT_LE(outsideBy(outline, *pixel), 0.01)
                << "case " << i << ": pixel " << pixel->x << ", " << pixel->y << ", outline of "
                << outline.size();
        }
    }
    EXPECT_GT(shown, 20000);
}

TEST(LampReach, OutlineIsNotMuchLargerThanTheBeam) {
    // From the side: a triangle with the apex at the middle of the picture, 10 m away.
    SpotLight lamp = makeSpot({0, 0, 0}, {1, 0, 0}, 10.0 * kDegree);
    lamp.rangeMetres = 2.0;
    const Camera camera = makeCamera({0, 0, 10}, {0, 0, 0}, 2.0 * std::atan(0.5));
    const double pixelsAMetre = 100.0 / 10.0;  // the picture is 10 m high there
    for (const glm::dvec2& corner : beamOutline(lamp, camera, 100, 100)) {
        EXPECT_GE(corner.x, 50.0 - 1e-6);
        EXPECT_LE(corner.x, 50.0 + pixelsAMetre * 2.0 * 1.1);
        EXPECT_LE(std::abs(corner.y - 50.0), pixelsAMetre * 2.0 * std::tan(10.0 * kDegree) * 1.1);
    }
}

TEST(LampReach, OutlineHasYUp) {
    SpotLight lamp = makeSpot({0, 2, 0}, {0, 4, 0}, 5.0 * kDegree);
    lamp.rangeMetres = 1.0;
    const auto outline = beamOutline(lamp, makeCamera({0, 0, 10}, {0, 0, 0}, 0.8), 100, 100);
    ASSERT_GE(outline.size(), 3U);
    for (const glm::dvec2& corner : outline) {
        EXPECT_GT(corner.y, 50.0);
    }
}

TEST(LampReach, ABeamBehindTheCameraHasNoOutline) {
    const SpotLight lamp = makeSpot({0, 0, 5}, {0, 0, 6}, 30.0 * kDegree);
    EXPECT_TRUE(beamOutline(lamp, makeCamera({0, 0, 0}, {0, 0, -1}), 100, 100).empty());
}

TEST(LampReach, DarkLampsAreTold) {
    SpotLight lamp = makeSpot({0, 0, 0}, {0, 0, -1}, 0.3);
    EXPECT_FALSE(isDark(lamp));
    SpotLight unpowered = lamp;
    unpowered.intensityCandela = 0.0;
    EXPECT_TRUE(isDark(unpowered));
    SpotLight black = lamp;
    black.color = glm::vec3(0.0F);
    EXPECT_TRUE(isDark(black));
    SpotLight blue = lamp;
    blue.color = {0.0F, 0.0F, 0.1F};
    EXPECT_FALSE(isDark(blue));
    SpotLight noRange = lamp;
    noRange.rangeMetres = 0.0;
    EXPECT_TRUE(isDark(noRange));
}

TEST(LampReach, LampSpaceHasDepthAlongTheBeamAndYUp) {
    const SpotLight lamp = makeSpot({1, 2, 3}, {1, 2, -7}, 0.3);
    const glm::dmat4 matrix = lampFromWorld(lamp);
    const auto at = [&](const glm::dvec3& world) {
        return glm::dvec3(matrix * glm::dvec4(world, 1.0));
    };
    EXPECT_LT(glm::length(at({1, 2, 3})), 1e-12);
    EXPECT_LT(glm::length(at({1, 2, -1}) - glm::dvec3(0, 0, 4)), 1e-12);
    EXPECT_LT(glm::length(at({2, 2, 3}) - glm::dvec3(1, 0, 0)), 1e-12);
    EXPECT_LT(glm::length(at({1, 3, 3}) - glm::dvec3(0, 1, 0)), 1e-12);
}

}  // namespace
}  // namespace ribalta::test
