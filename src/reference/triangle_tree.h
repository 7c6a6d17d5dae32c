// TriangleTree: boxes around triangles, halved down to a few in each, for questions that are no
// rays. Plain data; who asks walks it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

namespace ribalta {

struct TreeTriangle {
    std::array<glm::dvec3, 3> corners;  ///< metres, world
    std::uint32_t surface = 0;
    std::uint32_t triangle = 0;
};

struct TriangleTree {
    struct Box {
        glm::dvec3 centre{0.0};
        glm::dvec3 half{0.0};     ///< rounded up
        std::uint32_t first = 0;  ///< a leaf's first triangle, or the second child; the first child
                                  ///< follows its parent
        std::uint32_t count = 0;  ///< of a leaf's triangles; 0: not a leaf
    };

    std::vector<TreeTriangle> triangles;
    std::vector<Box> boxes;  ///< the root is first; empty without triangles

    /// Takes the triangles, puts them into the leaves' order.
    explicit TriangleTree(std::vector<TreeTriangle> all);

  private:
    void build(std::uint32_t first, std::uint32_t last);
};

}  // namespace ribalta
