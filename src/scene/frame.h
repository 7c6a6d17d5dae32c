// Frame: where a camera or a lamp stands and how it is turned. No scale.
#pragma once

#include <glm/glm.hpp>

namespace ribalta {

/// A rigid placement. Cameras and lamps look along their local -Z; +Y is up, +X right (glTF 2.0,
/// section 3.10 and KHR_lights_punctual).
struct Frame {
    glm::dvec3 position{0.0};        ///< metres, world
    glm::dmat3 worldFromLocal{1.0};  ///< orthonormal columns: right, up, backwards

    glm::dvec3 right() const { return worldFromLocal[0]; }
    glm::dvec3 up() const { return worldFromLocal[1]; }
    glm::dvec3 forward() const { return -worldFromLocal[2]; }
    bool operator==(const Frame&) const = default;
};

/// The placement a node's matrix gives to a camera or a lamp: its translation and its rotation,
/// with scale and shear taken out. A degenerate matrix gives the identity rotation.
Frame rigidFrame(const glm::dmat4& worldFromLocal);

/// A frame at `position` that looks at `target`; `up` is a hint and may be parallel to the view.
/// Without a direction to look in (`target` is `position`) it looks along -Z.
Frame lookAt(const glm::dvec3& position, const glm::dvec3& target,
             const glm::dvec3& up = {0.0, 1.0, 0.0});

}  // namespace ribalta
