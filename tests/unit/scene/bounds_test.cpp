#include "scene/bounds.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace ribalta {
namespace {

TEST(Bounds, EmptyUntilSomethingIsAdded) {
    Bounds bounds;
    EXPECT_TRUE(bounds.isEmpty());
    bounds.add(Bounds{});
    EXPECT_TRUE(bounds.isEmpty());
    bounds.add(glm::dvec3(1.0, -2.0, 3.0));
    EXPECT_FALSE(bounds.isEmpty()) << "a point is a box";
    EXPECT_EQ(bounds.centre(), glm::dvec3(1.0, -2.0, 3.0));
    EXPECT_EQ(bounds.halfSize(), glm::dvec3(0.0));
    bounds.add(Bounds{});
    EXPECT_EQ(bounds.low, glm::dvec3(1.0, -2.0, 3.0));
}

TEST(Bounds, CornersAreAllDifferentAndInside) {
    const Bounds bounds{{0.0, 1.0, 2.0}, {3.0, 5.0, 7.0}};
    EXPECT_EQ(bounds.corner(0), bounds.low);
    EXPECT_EQ(bounds.corner(1), glm::dvec3(3.0, 1.0, 2.0));
    EXPECT_EQ(bounds.corner(2), glm::dvec3(0.0, 5.0, 2.0));
    EXPECT_EQ(bounds.corner(4), glm::dvec3(0.0, 1.0, 7.0));
    EXPECT_EQ(bounds.corner(7), bounds.high);
}

TEST(Bounds, TransformedHoldsTheTurnedBox) {
    const Bounds unit{glm::dvec3(-1.0), glm::dvec3(1.0)};
    glm::dmat4 placed = glm::translate(glm::dmat4(1.0), {10.0, 0.0, 0.0});
    placed = glm::rotate(placed, glm::radians(45.0), glm::dvec3(0.0, 1.0, 0.0));
    placed = glm::scale(placed, {-2.0, 1.0, 1.0});
    const Bounds turned = transformed(placed, unit);
    EXPECT_NEAR(turned.high.x, 10.0 + 3.0 / std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(turned.low.z, -3.0 / std::sqrt(2.0), 1e-12);
    EXPECT_DOUBLE_EQ(turned.high.y, 1.0);
    EXPECT_TRUE(transformed(placed, Bounds{}).isEmpty());
}

}  // namespace
}  // namespace ribalta
