// Axis-aligned boxes.
#pragma once

#include <limits>

#include <glm/glm.hpp>

namespace ribalta {

/// An axis-aligned box in metres; empty until something is added.
struct Bounds {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    bool isEmpty() const { return low.x > high.x; }
    void add(const glm::dvec3& point);
    void add(const Bounds& other);
    glm::dvec3 centre() const { return 0.5 * (low + high); }
    glm::dvec3 halfSize() const { return 0.5 * (high - low); }
    /// Corner 0..7: bit 0 chooses x, bit 1 y, bit 2 z.
    glm::dvec3 corner(int index) const;
};

/// The box around a transformed box. Affine matrices only.
Bounds transformed(const glm::dmat4& destinationFromSource, const Bounds& bounds);

}  // namespace ribalta
