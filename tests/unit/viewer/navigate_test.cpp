// Moves of the camera, by what they must keep: the pivot in the middle, the horizon level,
// distances.
#include "viewer/navigate.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace ribalta {
namespace {

constexpr double kTiny = 1e-9;
constexpr glm::ivec2 kWindowSize(640, 360);

Bounds box() {
    Bounds bounds;
    bounds.add(glm::dvec3(-4.0, 0.0, -3.0));
    bounds.add(glm::dvec3(4.0, 5.0, 3.0));
    return bounds;
}

Viewpoint someView() {
    Camera camera;
    camera.frame = lookAt({6.0, 3.0, 9.0}, {0.5, 1.0, 0.0});
    return viewpointOf(camera, box());
}

// Where a point is seen, in pixels from the upper left.
glm::dvec2 seen(const Camera& camera, const glm::dvec3& point) {
    const glm::dvec4 clip =
        clipFromWorld(camera, kWindowSize.x, kWindowSize.y) * glm::dvec4(point, 1.0);
    return 0.5 * glm::dvec2(kWindowSize) * (1.0 + glm::dvec2(clip.x, -clip.y) / clip.w);
}

void expectLevel(const Viewpoint& view) {
    EXPECT_NEAR(view.camera.frame.right().y, 0.0, kTiny);
    EXPECT_GT(view.camera.frame.up().y, 0.0);
    const glm::dvec3 toPivot = glm::normalize(view.pivot - view.camera.frame.position);
    EXPECT_LT(glm::distance(toPivot, view.camera.frame.forward()), kTiny);
}

TEST(Viewpoint, ThePivotLiesAheadInTheScenesMiddle) {
    const Viewpoint view = someView();
    const Frame& frame = view.camera.frame;
    const glm::dvec3 ahead = view.pivot - frame.position;
    EXPECT_LT(glm::distance(glm::normalize(ahead), frame.forward()), kTiny);
    EXPECT_NEAR(glm::length(ahead), glm::dot(box().centre() - frame.position, frame.forward()),
                kTiny);
    // A scene behind the camera, and none at all.
    Camera away;
    away.frame = lookAt({0.0, 0.0, 50.0}, {0.0, 0.0, 100.0});
    EXPECT_GT(viewpointOf(away, box()).pivot.z, 50.0);
    EXPECT_GT(viewpointOf(away, Bounds{}).pivot.z, 50.0);
}

TEST(Orbit, KeepsPivotDistanceAndHorizon) {
    Viewpoint view = someView();
    const Viewpoint before = view;
    for (int i = 0; i < 200; ++i) {
        orbit(view, {0.37, i < 100 ? 0.05 : -0.11});
        EXPECT_EQ(view.pivot, before.pivot);
        EXPECT_NEAR(view.distance(), before.distance(), 1e-7);
        expectLevel(view);
    }
}

TEST(Orbit, GoesToTheRightAndUp) {
    Viewpoint view = someView();
    const glm::dvec3 before = view.camera.frame.position;
    const glm::dvec3 right = view.camera.frame.right();
    orbit(view, {0.1, 0.1});
    EXPECT_GT(glm::dot(view.camera.frame.position - before, right), 0.0);
    EXPECT_GT(view.camera.frame.position.y, before.y);
}

TEST(Orbit, AWholeTurnComesBack) {
    Viewpoint view = someView();
    const glm::dvec3 before = view.camera.frame.position;
    for (int i = 0; i < 8; ++i) {
        orbit(view, {0.25 * std::numbers::pi, 0.0});
    }
    EXPECT_LT(glm::distance(view.camera.frame.position, before), 1e-9);
}

TEST(LookAround, StaysWhereItStands) {
    Viewpoint view = someView();
    const Viewpoint before = view;
    const glm::dvec3 right = view.camera.frame.right();
    lookAround(view, {0.2, 0.1});
    EXPECT_EQ(view.camera.frame.position, before.camera.frame.position);
    EXPECT_NEAR(view.distance(), before.distance(), kTiny);
    EXPECT_GT(glm::dot(view.camera.frame.forward(), right), 0.0);
    expectLevel(view);
}

TEST(Pan, WhatLiesAtThePivotFollowsThePointer) {
    Viewpoint view = someView();
    const glm::dvec3 pivot = view.pivot;
    const glm::dvec2 before = seen(view.camera, pivot);
    pan(view, {37.0, -21.0}, kWindowSize);
    const glm::dvec2 after = seen(view.camera, pivot);
    EXPECT_NEAR(after.x - before.x, 37.0, 1e-6);
    EXPECT_NEAR(after.y - before.y, -21.0, 1e-6);

    Viewpoint flat = someView();
    flat.camera.lens = OrthographicLens{4.0, 3.0};
    flat.camera.farMetres = 100.0;
    const glm::dvec2 flatBefore = seen(flat.camera, flat.pivot);
    const glm::dvec3 flatPivot = flat.pivot;
    pan(flat, {10.0, 5.0}, kWindowSize);
    EXPECT_NEAR(seen(flat.camera, flatPivot).x - flatBefore.x, 10.0, 1e-6);
    EXPECT_NEAR(seen(flat.camera, flatPivot).y - flatBefore.y, 5.0, 1e-6);
    pan(flat, {10.0, 5.0}, {0, 0});  // a window without pixels
}

TEST(Dolly, ComesAsMuchNearer) {
    Viewpoint view = someView();
    const double before = view.distance();
    dolly(view, 0.5);
    EXPECT_NEAR(view.distance(), 0.5 * before, kTiny);
    for (int i = 0; i < 1000; ++i) {
        dolly(view, 0.5);
    }
    EXPECT_GT(view.distance(), 0.0);
    EXPECT_TRUE(std::isfinite(view.camera.frame.position.x));
}

TEST(Walk, TakesThePivotAlong) {
    Viewpoint view = someView();
    const Viewpoint before = view;
    walk(view, {1.0, 2.0, 3.0});
    const Frame& frame = before.camera.frame;
    const glm::dvec3 moved = frame.right() + 3.0 * frame.forward() + glm::dvec3(0.0, 2.0, 0.0);
    EXPECT_LT(glm::distance(view.camera.frame.position, frame.position + moved), kTiny);
    EXPECT_LT(glm::distance(view.pivot, before.pivot + moved), kTiny);
}

TEST(FrameBounds, AllOfItIsInView) {
    for (const bool orthographic : {false, true}) {
        Viewpoint view = someView();
        if (orthographic) {
            view.camera.lens = OrthographicLens{0.1, 0.1};
            view.camera.farMetres = 1.0;
        }
        frame(view, box(), double(kWindowSize.x) / kWindowSize.y);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec2 at = seen(view.camera, box().corner(corner));
            EXPECT_TRUE(at.x >= 0.0 && at.y >= 0.0 && at.x <= kWindowSize.x &&
                        at.y <= kWindowSize.y)
                << corner << ": " << at.x << ", " << at.y;
        }
        expectLevel(view);
        const Viewpoint before = view;
        frame(view, Bounds{}, 1.0);
        EXPECT_EQ(view, before);
    }
}

}  // namespace
}  // namespace ribalta
