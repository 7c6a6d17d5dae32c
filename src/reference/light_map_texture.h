// LightMapTexture: a lamp's picture as a texture unit reads it, in double precision. No mip levels.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "image/image.h"

namespace ribalta {

class LightMapTexture {
  public:
    /// Keeps linear R, G, B of `image` (8-bit channels are sRGB); alpha is not read.
    explicit LightMapTexture(const Image& image);

    /// The picture at half the size (a side of 1 stays), each texel the mean over its area.
    LightMapTexture halved() const;

    /// Linear R, G, B at `uv` (origin top left, v down): bilinear between texel centres, after
    /// decoding, clamped to the edge.
    glm::dvec3 at(const glm::dvec2& uv) const;

    /// Texels, columns and rows. at() has kinks where uv * size() - 0.5 is whole.
    glm::dvec2 size() const { return {width_, height_}; }

    /// The texels around a cell of that grid of kinks, which at() blends within it: upper left,
    /// upper right, lower left, lower right. Any column and row: beyond the edge they repeat.
    struct Cell {
        std::array<const glm::vec4*, 4> corners;
    };
    Cell cell(int column, int row) const {
        const std::size_t left = clampedColumn(column);
        const std::size_t right = clampedColumn(column + 1);
        const std::size_t upper = clampedRow(row) * std::size_t(width_);
        const std::size_t lower = clampedRow(row + 1) * std::size_t(width_);
        return {{&texels_[upper + left], &texels_[upper + right], &texels_[lower + left],
                 &texels_[lower + right]}};
    }
    /// Whether the cell's four texels are black.
    bool isDark(int column, int row) const {
        const auto x = std::size_t(glm::clamp(column + 1, 0, width_));
        const auto y = std::size_t(glm::clamp(row + 1, 0, height_));
        return dark_[y * (std::size_t(width_) + 1) + x] != 0;
    }

  private:
    LightMapTexture(int width, int height, std::vector<glm::vec4> texels);

    std::size_t clampedColumn(int column) const {
        return std::size_t(glm::clamp(column, 0, width_ - 1));
    }
    std::size_t clampedRow(int row) const { return std::size_t(glm::clamp(row, 0, height_ - 1)); }
    void findDark();

    int width_;
    int height_;
    std::vector<glm::vec4> texels_;   ///< w unused, for whole-register reads
    std::vector<std::uint8_t> dark_;  ///< by cell, (width + 1) x (height + 1)
};

}  // namespace ribalta
