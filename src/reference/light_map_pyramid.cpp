#include "reference/light_map_pyramid.h"

#include <algorithm>
#include <cmath>

namespace ribalta {

LightMapPyramid::LightMapPyramid(const Image& image)
    : levels_{LightMapTexture(image)}, side_(std::max(image.width, image.height)) {
    while (levels_.back().size() != glm::dvec2(1.0)) {
        levels_.push_back(levels_.back().halved());
    }
}

glm::dvec3 LightMapPyramid::at(const glm::dvec2& uv, double level) const {
    const double kept = glm::clamp(level, 0.0, double(lastLevel()));
    const int finer = int(kept);
    const int coarser = std::min(finer + 1, lastLevel());
    return glm::mix(this->level(finer).at(uv), this->level(coarser).at(uv), kept - finer);
}

}  // namespace ribalta
