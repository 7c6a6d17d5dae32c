// Pose: a node's placement in parts, so that one of them may move and the others stay.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace ribalta {

/// Scaled first, then turned, then moved (glTF 2.0, section 3.5.3).
struct Pose {
    glm::dvec3 translation{0.0};              ///< metres, in the parent's axes
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};  ///< unit; w, x, y, z
    glm::dvec3 scale{1.0};

    glm::dmat4 parentFromLocal() const {
        glm::dmat4 matrix = glm::mat4_cast(rotation);
        for (int axis = 0; axis < 3; ++axis) {
            matrix[axis] *= scale[axis];
        }
        matrix[3] = glm::dvec4(translation, 1.0);
        return matrix;
    }
};

}  // namespace ribalta
