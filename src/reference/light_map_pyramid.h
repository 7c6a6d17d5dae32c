// LightMapPyramid: a light map at full size and halved again and again, for what a pixel sees of it
// at once.
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "reference/light_map_texture.h"

namespace ribalta {

class LightMapPyramid {
  public:
    explicit LightMapPyramid(const Image& image);

    /// Level 0 is the picture itself; the last is one texel.
    const LightMapTexture& level(int index) const { return levels_[std::size_t(index)]; }
    int lastLevel() const { return int(levels_.size()) - 1; }
    /// Texels of the longer side.
    double side() const { return side_; }

    /// R, G, B at `uv`, blended between the levels around `level`, which is kept within those
    /// there.
    glm::dvec3 at(const glm::dvec2& uv, double level) const;

  private:
    std::vector<LightMapTexture> levels_;
    double side_;
};

}  // namespace ribalta
