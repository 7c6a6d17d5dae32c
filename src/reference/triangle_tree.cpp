#include "reference/triangle_tree.h"

#include <algorithm>
#include <utility>

#include "scene/bounds.h"

namespace ribalta {
namespace {

constexpr std::uint32_t kLeafTriangles = 4;

glm::dvec3 centreOf(const TreeTriangle& triangle) {
    return (triangle.corners[0] + triangle.corners[1] + triangle.corners[2]) / 3.0;
}

}  // namespace

TriangleTree::TriangleTree(std::vector<TreeTriangle> all) : triangles(std::move(all)) {
    if (!triangles.empty()) {
        boxes.reserve(triangles.size());
        build(0, std::uint32_t(triangles.size()));
    }
}

// Halves the triangles along the longest side of the box around their centres.
void TriangleTree::build(std::uint32_t first, std::uint32_t last) {
    Bounds bounds;
    Bounds centres;
    for (std::uint32_t i = first; i < last; ++i) {
        for (const glm::dvec3& corner : triangles[i].corners) {
            bounds.add(corner);
        }
        centres.add(centreOf(triangles[i]));
    }
    const std::size_t index = boxes.size();
    Box box;
    box.centre = bounds.centre();
    // A flat box's centre is rounded; its faces are not to be lost by that.
    const glm::dvec3 size = glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
    box.half = bounds.halfSize() + 1e-15 * size;
    boxes.push_back(box);
    if (last - first <= kLeafTriangles) {
        boxes[index].first = first;
        boxes[index].count = last - first;
        return;
    }
    const glm::dvec3 spread = centres.high - centres.low;
    int axis = spread.x > spread.y ? 0 : 1;
    axis = spread[axis] > spread.z ? axis : 2;
    const std::uint32_t middle = first + (last - first) / 2;
    const auto at = [&](std::uint32_t i) { return triangles.begin() + std::ptrdiff_t(i); };
    std::nth_element(at(first), at(middle), at(last),
                     [&](const TreeTriangle& a, const TreeTriangle& b) {
                         return centreOf(a)[axis] < centreOf(b)[axis];
                     });
    build(first, middle);
    boxes[index].first = std::uint32_t(boxes.size());
    build(middle, last);
}

}  // namespace ribalta
