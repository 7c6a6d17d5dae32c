// What the projections do to known points, and which part of the view a picture's shape keeps.

#include "scene/camera.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/angles.h"
#include "support/expect_near.h"

namespace ribalta {
namespace {

using test::expectNear;

/// Normalised device coordinates of a world point: x and y in -1..1, depth in 0..1.
glm::dvec3 project(const Camera& camera, const glm::dvec3& point, int width = 200,
                   int height = 100) {
    const glm::dvec4 clip = clipFromWorld(camera, width, height) * glm::dvec4(point, 1.0);
    return glm::dvec3(clip) / clip.w;
}

Camera perspective(double near, double far) {
    Camera camera;
    camera.lens = PerspectiveLens{kPi / 2.0, std::nullopt};
    camera.nearMetres = near;
    camera.farMetres = far;
    return camera;
}

Camera orthographic(double near, double far) {
    Camera camera = perspective(near, far);
    camera.lens = OrthographicLens{4.0, 2.0};
    return camera;
}

TEST(ClipFromWorld, DepthIsOneAtNearAndZeroAtFar) {
    expectNear(project(perspective(0.5, 100.0), {0.0, 0.0, -0.5}), {0.0, 0.0, 1.0});
    expectNear(project(perspective(0.5, 100.0), {0.0, 0.0, -100.0}), {0.0, 0.0, 0.0});
    expectNear(project(orthographic(0.5, 100.0), {0.0, 0.0, -0.5}), {0.0, 0.0, 1.0});
    expectNear(project(orthographic(0.5, 100.0), {0.0, 0.0, -100.0}), {0.0, 0.0, 0.0});
}

TEST(ClipFromWorld, InfinitePerspectiveReachesZeroFarAway) {
    const Camera camera = perspective(0.5, std::numeric_limits<double>::infinity());
    expectNear(project(camera, {0.0, 0.0, -0.5}), {0.0, 0.0, 1.0});
    expectNear(project(camera, {0.0, 0.0, -5.0}), {0.0, 0.0, 0.1});
    EXPECT_LT(project(camera, {0.0, 0.0, -1e12}).z, 1e-11);
    EXPECT_GT(project(camera, {0.0, 0.0, -1e12}).z, 0.0);
}

TEST(ClipFromWorld, DepthFallsWithDistance) {
    for (const Camera& camera : {perspective(0.1, 50.0), orthographic(0.1, 50.0)}) {
        double before = 2.0;
        for (double distance = 0.1; distance <= 50.0; distance *= 1.3) {
            const double depth = project(camera, {0.3, 0.2, -distance}).z;
            EXPECT_LT(depth, before);
            before = depth;
        }
    }
}

TEST(ClipFromWorld, RightIsRightAndUpIsUp) {
    // 90 degrees high at 2 : 1: the picture's corner is at (2, 1) for a distance of 1.
    expectNear(project(perspective(1.0, 2.0), {2.0, 1.0, -1.0}), {1.0, 1.0, 1.0});
    expectNear(project(orthographic(1.0, 2.0), {4.0, -2.0, -2.0}), {1.0, -1.0, 0.0});
}

TEST(ClipFromWorld, FollowsTheFrame) {
    Camera camera = perspective(1.0, 100.0);
    camera.frame = lookAt({10.0, 5.0, 0.0}, {0.0, 5.0, 0.0});  // looks along -x: -z is right
    const glm::dvec3 seen = project(camera, {0.0, 7.0, -4.0});
    EXPECT_NEAR(seen.x, 4.0 / 10.0 / 2.0, 1e-12);
    EXPECT_NEAR(seen.y, 2.0 / 10.0, 1e-12);
}

TEST(ViewFromWorld, IsTheInverse) {
    Camera camera;
    camera.frame = lookAt({1.0, 2.0, 3.0}, {-4.0, 0.0, 2.5});
    const glm::dmat4 product = viewFromWorld(camera) * worldFromView(camera);
    for (int column = 0; column < 4; ++column) {
        EXPECT_NEAR(glm::length(product[column] - glm::dmat4(1.0)[column]), 0.0, 1e-12);
    }
}

TEST(ViewHalfExtent, NarrowerPicturesKeepTheWidthAndWiderOnesTheHeight) {
    Camera camera;
    camera.lens = PerspectiveLens{2.0 * std::atan(0.5), 2.0};
    const auto expectExtent = [&](int width, int height, glm::dvec2 expected) {
        const glm::dvec2 half = viewHalfExtent(camera, width, height);
        EXPECT_NEAR(half.x, expected.x, 1e-12) << width << 'x' << height;
        EXPECT_NEAR(half.y, expected.y, 1e-12) << width << 'x' << height;
    };
    expectExtent(200, 100, {1.0, 0.5});
    expectExtent(400, 100, {2.0, 0.5});
    expectExtent(100, 100, {1.0, 1.0});
    camera.lens = PerspectiveLens{2.0 * std::atan(0.5), std::nullopt};
    expectExtent(100, 100, {0.5, 0.5});
    camera.lens = OrthographicLens{4.0, 2.0};
    expectExtent(200, 100, {4.0, 2.0});
    expectExtent(400, 100, {8.0, 2.0});
    expectExtent(100, 100, {4.0, 4.0});
}

TEST(FramingCamera, SeesTheWholeBoxWhateverThePicturesShape) {
    const Bounds box{{-3.0, 0.0, -50.0}, {7.0, 2.0, 1.0}};
    for (const auto& [width, height] : {std::pair{300, 100}, {100, 100}, {100, 300}}) {
        const Camera camera = makeFramingCamera(box, double(width) / height);
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 seen = project(camera, box.corner(i), width, height);
            EXPECT_LE(std::abs(seen.x), 1.0);
            EXPECT_LE(std::abs(seen.y), 1.0);
            EXPECT_GT(seen.z, 0.0);
            EXPECT_LE(seen.z, 1.0);
        }
    }
}

TEST(FramingCamera, IsFiniteForAPointAndForNothing) {
    for (const Bounds& bounds : {Bounds{}, Bounds{glm::dvec3(5.0), glm::dvec3(5.0)}}) {
        const Camera camera = makeFramingCamera(bounds, 1.5);
        const glm::dvec3 seen =
            project(camera, bounds.isEmpty() ? glm::dvec3(0.0) : bounds.centre());
        expectNear({seen.x, seen.y, 0.0}, {0.0, 0.0, 0.0});
        EXPECT_GT(camera.nearMetres, 0.0);
    }
}

}  // namespace
}  // namespace ribalta
