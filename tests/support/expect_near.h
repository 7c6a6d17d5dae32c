// Points and directions that are to be the same.
#pragma once

#include <glm/glm.hpp>
#include <gtest/gtest.h>

namespace ribalta::test {

inline void expectNear(const glm::dvec3& found, const glm::dvec3& expected,
                       double tolerance = 1e-9) {
    EXPECT_NEAR(glm::length(found - expected), 0.0, tolerance)
        << found.x << ' ' << found.y << ' ' << found.z;
}

}  // namespace ribalta::test
