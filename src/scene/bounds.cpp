#include "scene/bounds.h"

namespace ribalta {

void Bounds::add(const glm::dvec3& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
}

void Bounds::add(const Bounds& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
}

glm::dvec3 Bounds::corner(int index) const {
    return {(index & 1) != 0 ? high.x : low.x, (index & 2) != 0 ? high.y : low.y,
            (index & 4) != 0 ? high.z : low.z};
}

Bounds transformed(const glm::dmat4& destinationFromSource, const Bounds& bounds) {
    Bounds result;
    if (bounds.isEmpty()) {
        return result;
    }
    for (int i = 0; i < 8; ++i) {
        result.add(glm::dvec3(destinationFromSource * glm::dvec4(bounds.corner(i), 1.0)));
    }
    return result;
}

}  // namespace ribalta
