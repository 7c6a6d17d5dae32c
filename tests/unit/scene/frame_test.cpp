// Rigid placements from any matrix a file may hold.

#include "scene/frame.h"

#include <cmath>
#include <limits>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "support/expect_near.h"

namespace ribalta {
namespace {

using test::expectNear;

void expectRotation(const glm::dmat3& matrix) {
    const glm::dmat3 product = glm::transpose(matrix) * matrix;
    for (int column = 0; column < 3; ++column) {
        expectNear(product[column], glm::dmat3(1.0)[column]);
    }
    EXPECT_NEAR(glm::determinant(matrix), 1.0, 1e-9);
}

glm::dmat4 turned() {
    const glm::dmat4 moved = glm::translate(glm::dmat4(1.0), {1.0, 2.0, 3.0});
    return glm::rotate(moved, 0.7, glm::normalize(glm::dvec3(1.0, 2.0, -0.5)));
}

TEST(RigidFrame, KeepsARotation) {
    const Frame frame = rigidFrame(turned());
    expectNear(frame.position, {1.0, 2.0, 3.0});
    for (int column = 0; column < 3; ++column) {
        expectNear(frame.worldFromLocal[column], glm::dvec3(turned()[column]));
    }
}

TEST(RigidFrame, TakesOutScale) {
    for (const double scale : {1e-6, 1.0, 1e6}) {
        const Frame frame = rigidFrame(glm::scale(turned(), {scale, 2.0 * scale, 3.0 * scale}));
        expectRotation(frame.worldFromLocal);
        expectNear(frame.forward(), -glm::dvec3(turned()[2]));
        expectNear(frame.up(), glm::dvec3(turned()[1]));
    }
}

TEST(RigidFrame, MirroredAndShearedStillAimAlongMinusZ) {
    for (const glm::dvec3& mirror :
         {glm::dvec3(-1.0, 1.0, 1.0), glm::dvec3(1.0, -1.0, 1.0), glm::dvec3(1.0, 1.0, -1.0)}) {
        const glm::dmat4 matrix = glm::scale(turned(), mirror);
        const Frame frame = rigidFrame(matrix);
        expectRotation(frame.worldFromLocal);
        expectNear(frame.forward(), -glm::dvec3(matrix[2]));
    }
    glm::dmat4 sheared = turned();
    sheared[1] += 0.8 * sheared[2] + 0.3 * sheared[0];
    const Frame frame = rigidFrame(sheared);
    expectRotation(frame.worldFromLocal);
    expectNear(frame.forward(), -glm::dvec3(sheared[2]));
    EXPECT_GT(glm::dot(frame.up(), glm::dvec3(sheared[1])), 0.0);
}

TEST(RigidFrame, DegenerateMatricesKeepTheirPlace) {
    glm::dmat4 flat = turned();
    flat[2] = flat[1];
    glm::dmat4 broken = turned();
    broken[1].x = std::numeric_limits<double>::quiet_NaN();
    for (const glm::dmat4& matrix : {glm::scale(turned(), glm::dvec3(0.0)), flat, broken}) {
        const Frame frame = rigidFrame(matrix);
        expectNear(frame.position, {1.0, 2.0, 3.0});
        expectRotation(frame.worldFromLocal);
    }
}

TEST(LookAt, FacesItsTargetUpright) {
    const Frame frame = lookAt({0.0, 5.0, 10.0}, {0.0, 5.0, 0.0});
    expectNear(frame.forward(), {0.0, 0.0, -1.0});
    expectNear(frame.up(), {0.0, 1.0, 0.0});
    expectNear(frame.right(), {1.0, 0.0, 0.0});
}

TEST(LookAt, CopesWithAnyDirection) {
    const glm::dvec3 here(1.0, 2.0, 3.0);
    for (const glm::dvec3& up : {glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(0.0, 0.0, 1.0)}) {
        for (const glm::dvec3& way :
             {glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(0.0, -1.0, 0.0), glm::dvec3(0.0, 0.0, 1.0),
              glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(1.0, 0.0, 0.0)}) {
            const Frame frame = lookAt(here, here + 4.0 * way, up);
            expectRotation(frame.worldFromLocal);
            expectNear(frame.forward(), way);
        }
    }
    expectRotation(lookAt(here, here).worldFromLocal);
}

}  // namespace
}  // namespace ribalta
