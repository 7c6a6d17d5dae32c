// LightMapTexture: a lamp's picture as a texture unit reads it, in double precision. No mip levels.
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "image/image.h"

namespace ribalta {

class LightMapTexture {
  public:
    /// Keeps linear R, G, B of `image` (8-bit channels are sRGB); alpha is not read.
    explicit LightMapTexture(const Image& image);

    /// Linear R, G, B at `uv` (origin top left, v down): bilinear between texel centres, after
    /// decoding, clamped to the edge.
    glm::dvec3 at(const glm::dvec2& uv) const;

    /// Texels, columns and rows. at() has kinks where uv * size() - 0.5 is whole.
    glm::dvec2 size() const { return {width_, height_}; }

  private:
    int width_;
    int height_;
    std::vector<glm::vec3> texels_;
};

}  // namespace ribalta
