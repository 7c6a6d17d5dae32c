// Texture coordinates and depth in the map are linear in the segment's x, so the ray crosses the
// texels in a straight line, and within one it is as near as the map's depth at one x at most.
#include "reference/shadow_map_visibility.h"

#include <algorithm>

#include "optics/shader_lib.h"
#include "reference/walk_texels.h"

namespace ribalta {
namespace {

/// The part of first..last where the linear a + b x is not below zero; empty: first > last.
Interval notBelowZero(double a, double b, Interval part) {
    if (b > 0.0) {
        part.first = std::max(part.first, -a / b);
    } else if (b < 0.0) {
        part.last = std::min(part.last, -a / b);
    } else if (a < 0.0) {
        part.last = part.first - 1.0;
    }
    return part;
}

}  // namespace

void ShadowMapVisibility::findLit(const BeamSegment& segment, std::vector<Interval>& lit) const {
    lit.clear();
    const std::optional<DrawnShadowMap>& map = maps_[std::size_t(segment.lamp.index)];
    if (!map) {
        lit.push_back({0.0, 1.0});
        return;
    }
    const glm::dvec3 from = shader::shadowCoordinates(segment.slope0, 1.0 / segment.z0,
                                                      map->inverseTan, map->nearMetres);
    const glm::dvec3 to = shader::shadowCoordinates(segment.slope1, 1.0 / segment.z1,
                                                    map->inverseTan, map->nearMetres);
    const double side = map->side;
    walkCells(
        glm::dvec2(from) * side, glm::dvec2(to) * side, 0.0, 1.0,
        [&](int column, int row, double first, double last) {
            Interval part{first, last};
            if (column >= 0 && row >= 0 && column < map->side && row < map->side) {
                const double depth =
                    map->depths[std::size_t(row) * std::size_t(map->side) + std::size_t(column)];
                part = notBelowZero(from.z - depth, to.z - from.z, part);
            }
            if (!(part.first < part.last)) {
                return;
            }
            if (!lit.empty() && lit.back().last == part.first) {
                lit.back().last = part.last;
            } else {
                lit.push_back(part);
            }
        });
}

}  // namespace ribalta
