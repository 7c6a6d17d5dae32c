// Walking over a picture's cells along a straight line, each crossing exact.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/glm.hpp>

namespace ribalta {

/// Calls visit(column, row, xFrom, xTo) for every unit cell that the line crosses on its way from
/// `from` (at x = 0) to `to` (at x = 1) within first..last of x, in order; cell (i, j) holds points
/// in i..i+1, j..j+1. Columns and rows may lie outside of a picture. Everything finite.
template <typename Visit>
void walkCells(const glm::dvec2& from, const glm::dvec2& to, double first, double last,
               Visit&& visit) {
    const glm::dvec2 along = to - from;
    int cell[2];
    double next[2];  // the x at which the line leaves the cell along each axis
    const auto leave = [&](int axis) {
        if (along[axis] == 0.0) {
            return std::numeric_limits<double>::infinity();
        }
        const double edge = along[axis] > 0.0 ? cell[axis] + 1.0 : double(cell[axis]);
        return (edge - from[axis]) / along[axis];
    };
    for (int axis = 0; axis < 2; ++axis) {
        const double start = from[axis] + first * along[axis];
        cell[axis] = along[axis] < 0.0 ? int(std::ceil(start)) - 1 : int(std::floor(start));
        next[axis] = leave(axis);
    }
    double x = first;
    while (x < last) {
        const int axis = next[0] <= next[1] ? 0 : 1;
        const double end = std::min(std::max(next[axis], x), last);
        if (end > x) {
            visit(cell[0], cell[1], x, end);
        }
        x = end;
        cell[axis] += along[axis] > 0.0 ? 1 : -1;
        next[axis] = leave(axis);
    }
}

}  // namespace ribalta
