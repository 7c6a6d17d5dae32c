// Where lamps are marked, and where they aim.
#include "viewer/lamp_marks.h"

#include <gtest/gtest.h>

namespace ribalta {
namespace {

constexpr glm::ivec2 kSize(200, 100);

Camera cameraAtOrigin() {
    Camera camera;
    camera.lens = PerspectiveLens{2.0 * std::atan(0.5), std::nullopt};
    return camera;
}

TEST(Project, FindsThePixel) {
    const auto middle = project(cameraAtOrigin(), kSize, {0.0, 0.0, -4.0});
    ASSERT_TRUE(middle);
    EXPECT_NEAR(middle->at.x, 100.0, 1e-9);
    EXPECT_NEAR(middle->at.y, 50.0, 1e-9);
    EXPECT_NEAR(middle->depth, 4.0, 1e-9);
    // Half a height above and a width's quarter to the right.
    const auto corner = project(cameraAtOrigin(), kSize, {2.0, 2.0, -4.0});
    ASSERT_TRUE(corner);
    EXPECT_NEAR(corner->at.x, 150.0, 1e-9);
    EXPECT_NEAR(corner->at.y, 0.0, 1e-9);
    EXPECT_FALSE(project(cameraAtOrigin(), kSize, {0.0, 0.0, 1.0}));
}

TEST(Project, OrthographicCamerasToo) {
    Camera camera;
    camera.lens = OrthographicLens{4.0, 2.0};
    camera.farMetres = 10.0;
    const auto seen = project(camera, kSize, {1.0, -1.0, -5.0});
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->at.x, 125.0, 1e-9);
    EXPECT_NEAR(seen->at.y, 75.0, 1e-9);
}

TEST(Turned, LooksThereWithoutRolling) {
    // A gobo that stands askew keeps its angle to the horizon when it is swung along it.
    Frame frame = lookAt({1.0, 2.0, 3.0}, {1.0, 2.0, -3.0});
    const double roll = 0.3;
    const glm::dmat3 axes = frame.worldFromLocal;
    frame.worldFromLocal[0] = std::cos(roll) * axes[0] + std::sin(roll) * axes[1];
    frame.worldFromLocal[1] = std::cos(roll) * axes[1] - std::sin(roll) * axes[0];
    const Frame swung = turned(frame, {5.0, 0.0, -5.0});
    EXPECT_EQ(swung.position, frame.position);
    EXPECT_LT(glm::distance(swung.forward(), glm::normalize(glm::dvec3(1.0, 0.0, -1.0))), 1e-12);
    EXPECT_NEAR(swung.right().y, frame.right().y, 1e-12);
    for (const glm::dvec3& direction :
         {frame.forward(), -frame.forward(), glm::dvec3(0.0, -2.0, 0.0)}) {
        const Frame end = turned(frame, direction);
        EXPECT_LT(glm::distance(end.forward(), glm::normalize(direction)), 1e-9);
        EXPECT_NEAR(glm::determinant(end.worldFromLocal), 1.0, 1e-12);
    }
}

TEST(AimOf, EndsOnTheScenesFloor) {
    Scene scene;
    scene.spotLights.emplace_back();
    scene.spotLights[0].frame = lookAt({0.0, 5.0, 0.0}, {1.0, 3.0, 0.0});
    scene.pointLights.emplace_back();
    Bounds bounds;
    bounds.add(glm::dvec3(-10.0, 1.0, -10.0));
    bounds.add(glm::dvec3(10.0, 6.0, 10.0));
    const auto aim = aimOf(scene, {LampId::Kind::kSpot, 0, "", 0}, bounds);
    ASSERT_TRUE(aim);
    EXPECT_NEAR(aim->x, 2.0, 1e-9);
    EXPECT_NEAR(aim->y, 1.0, 1e-9);
    // Upwards there is no floor.
    scene.spotLights[0].frame = lookAt({0.0, 5.0, 0.0}, {0.0, 8.0, 0.1});
    EXPECT_GT(aimOf(scene, {LampId::Kind::kSpot, 0, "", 0}, bounds)->y, 5.0);
    EXPECT_TRUE(aimOf(scene, {LampId::Kind::kSpot, 0, "", 0}, Bounds{}));
    EXPECT_FALSE(aimOf(scene, {LampId::Kind::kPoint, 0, "", 0}, bounds));
}

}  // namespace
}  // namespace ribalta
