// In the plane of lamp and ray a point q, seen from the lamp, has the coordinates s along the ray
// and w across, towards the ray, which lies at w = h. It hides the ray's point at s h / w where
// 0 < w < h.
#include "reference/triangle_shadows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "optics/shader_lib.h"
#include "reference/lit_stretches.h"
#include "reference/triangle_tree.h"
#include "reference/walk_texels.h"

namespace ribalta {
namespace {

/// A ray that runs through the lamp itself spans no plane with it; it is taken to miss it by so
/// much, in metres.
constexpr double kLeastMiss = 1e-9;
/// Dark stretches nearer to each other than this, in the segment's x, are one: rounding at the edge
/// that two triangles share.
constexpr double kSeam = 1e-12;

/// The triangle of lamp and ray, in which shadows on the ray are cast. All about the lamp.
struct Fan {
    glm::dvec3 along;        ///< unit, the ray's direction
    glm::dvec3 across;       ///< unit, from the lamp to the ray
    glm::dvec3 normal;       ///< unit
    double h = 0.0;          ///< metres from the lamp to the ray's line
    double nearest = 0.0;    ///< metres along the ray to the point nearest to the lamp
    glm::dvec3 insideFirst;  ///< of points q, dot(insideFirst, q) >= 0 where the fan is: beyond its
    glm::dvec3 insideLast;   ///< first and before its last side
    glm::dvec3 axis;         ///< the lamp's

    explicit Fan(const BeamSegment& segment);
};

Fan::Fan(const BeamSegment& segment)
    : along(segment.worldDirection), axis(segment.lamp.light.frame.forward()) {
    const glm::dvec3 moment = glm::cross(segment.worldOrigin, along);
    h = glm::length(moment);
    if (h > kLeastMiss) {
        normal = moment / h;
    } else {
        const glm::dvec3 other =
            std::abs(along.x) < 0.7 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
        normal = glm::normalize(glm::cross(other, along));
        h = kLeastMiss;
    }
    // With q = nearest point = h across: cross(q, along) = h normal.
    across = glm::cross(along, normal);
    nearest = -glm::dot(segment.worldOrigin, along);
    insideFirst = h * along - (segment.part.first - nearest) * across;
    insideLast = (segment.part.last - nearest) * across - h * along;
}

/// A piece of the line in which a triangle cuts the fan's plane; from + m way for m of first..last.
struct Cut {
    glm::dvec3 from;
    glm::dvec3 way;
    double first = 0.0;
    double last = 1.0;

    /// Keeps what lies where offset + m slope >= 0; false where that is nothing.
    bool keep(double offset, double slope) {
        if (slope > 0.0) {
            first = std::max(first, -offset / slope);
        } else if (slope < 0.0) {
            last = std::min(last, -offset / slope);
        } else if (offset < 0.0) {
            return false;
        }
        return first < last;
    }
    glm::dvec3 at(double m) const { return from + m * way; }
};

/// A point on a triangle's edge, about the lamp, and its weights.
struct Crossing {
    glm::dvec3 point{0.0};
    glm::dvec3 weights{0.0};
};

/// The two points where a triangle's edges cross the fan's plane; false where they do not.
bool crossPlane(const Fan& fan, const std::array<glm::dvec3, 3>& corners,
                std::array<Crossing, 2>& crossings) {
    std::array<double, 3> heights{};
    for (std::size_t i = 0; i < 3; ++i) {
        heights[i] = glm::dot(fan.normal, corners[i]);
    }
    const auto above = [&](std::size_t i) { return heights[i] >= 0.0; };
    if (above(0) == above(1) && above(1) == above(2)) {
        return false;
    }
    // The corner that is alone on its side.
    const std::size_t alone = above(0) == above(1) ? 2 : above(0) == above(2) ? 1 : 0;
    for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t other = (alone + 1 + i) % 3;
        const double share = heights[alone] / (heights[alone] - heights[other]);
        crossings[i].point = glm::mix(corners[alone], corners[other], share);
        crossings[i].weights = glm::dvec3(0.0);
        crossings[i].weights[int(alone)] = 1.0 - share;
        crossings[i].weights[int(other)] = share;
    }
    return true;
}

/// The part of the cut that keeps light from the ray.
bool clipToFan(const Fan& fan, Cut& cut) {
    const double w = glm::dot(fan.across, cut.from);
    const double wSlope = glm::dot(fan.across, cut.way);
    // A trace before the ray: the surface that the ray ends on does not shade that end.
    constexpr double kBefore = 1.0 - 1e-9;
    return cut.keep(w, wSlope) && cut.keep(kBefore * fan.h - w, -wSlope) &&
           cut.keep(glm::dot(fan.insideFirst, cut.from), glm::dot(fan.insideFirst, cut.way)) &&
           cut.keep(glm::dot(fan.insideLast, cut.from), glm::dot(fan.insideLast, cut.way)) &&
           cut.keep(glm::dot(fan.axis, cut.from) - shader::kLensMetres,
                    glm::dot(fan.axis, cut.way));
}

/// Whether some of a box may lie in the fan.
bool touches(const Fan& fan, const glm::dvec3& lamp, const TriangleTree::Box& box) {
    const glm::dvec3 centre = box.centre - lamp;
    const auto reach = [&](const glm::dvec3& direction) {
        return glm::dot(glm::abs(direction), box.half);
    };
    const double w = glm::dot(fan.across, centre);
    const double wReach = reach(fan.across);
    return std::abs(glm::dot(fan.normal, centre)) <=
               reach(fan.normal) + 1e-15 * glm::length(lamp) &&
           w + wReach >= 0.0 && w - wReach <= fan.h &&
           glm::dot(fan.insideFirst, centre) + reach(fan.insideFirst) >= 0.0 &&
           glm::dot(fan.insideLast, centre) + reach(fan.insideLast) >= 0.0;
}

/// Sorts dark stretches and turns them into the lit ones between them.
void invert(std::vector<Interval>& dark, std::vector<Interval>& lit) {
    std::sort(dark.begin(), dark.end(),
              [](const Interval& a, const Interval& b) { return a.first < b.first; });
    lit.clear();
    double from = 0.0;
    for (const Interval& stretch : dark) {
        if (stretch.first > from + kSeam) {
            lit.push_back({from, stretch.first});
        }
        from = std::max(from, stretch.last);
    }
    if (from < 1.0) {
        lit.push_back({from, 1.0});
    }
}

}  // namespace

struct TriangleShadows::Tree {
    std::span<const PlacedSurface> surfaces;
    const MaterialTextures& textures;
    TriangleTree tree;

    void hideByTriangle(const Fan& fan, const BeamSegment& segment, const TreeTriangle& triangle,
                        std::vector<Interval>& dark) const;
    void hideByMask(const TreeTriangle& triangle, const std::array<Crossing, 2>& crossings,
                    const Cut& cut, std::vector<Interval>& opaque) const;
};

/// The parts of the cut where a masked surface is there, within cut.first..last.
void TriangleShadows::Tree::hideByMask(const TreeTriangle& triangle,
                                       const std::array<Crossing, 2>& crossings, const Cut& cut,
                                       std::vector<Interval>& opaque) const {
    const PlacedSurface& surface = surfaces[triangle.surface];
    const auto weights = [&](double m) {
        return glm::mix(crossings[0].weights, crossings[1].weights, m);
    };
    std::vector<double> probes = {cut.first, cut.last};
    const std::optional<TextureSlot>& slot = surface.material->baseColorTexture;
    if (slot) {
        // Within a texel's cell alpha is a polynomial of low degree; a few probes see its turns.
        const glm::dvec2 size = textures.size(*slot);
        const auto texel = [&](double m) {
            return MaterialTextures::coordinates(*slot, surface, triangle.triangle, weights(m)) *
                       size -
                   0.5;
        };
        walkCells(texel(0.0), texel(1.0), cut.first, cut.last,
                  [&](int /*column*/, int /*row*/, double first, double last) {
                      for (int i = 0; i <= 4; ++i) {
                          probes.push_back(first + (last - first) * 0.25 * i);
                      }
                  });
    }
    std::sort(probes.begin(), probes.end());
    opaque = litStretches(
        [&](double m) { return textures.isThere(surface, triangle.triangle, weights(m)); }, probes);
}

void TriangleShadows::Tree::hideByTriangle(const Fan& fan, const BeamSegment& segment,
                                           const TreeTriangle& triangle,
                                           std::vector<Interval>& dark) const {
    const glm::dvec3& lamp = segment.lamp.light.frame.position;
    std::array<Crossing, 2> crossings;
    if (!crossPlane(
            fan,
            {triangle.corners[0] - lamp, triangle.corners[1] - lamp, triangle.corners[2] - lamp},
            crossings)) {
        return;
    }
    Cut cut{crossings[0].point, crossings[1].point - crossings[0].point};
    if (!clipToFan(fan, cut)) {
        return;
    }
    const auto placeOf = [&](double m) {
        const glm::dvec3 q = cut.at(m);
        const double s = glm::dot(fan.along, q) * fan.h / glm::dot(fan.across, q);
        return segment.placeOf(s + fan.nearest);
    };
    const auto hide = [&](const Interval& part) {
        const double a = placeOf(part.first);
        const double b = placeOf(part.last);
        dark.push_back({std::min(a, b), std::max(a, b)});
    };
    if (!surfaces[triangle.surface].isMasked()) {
        hide({cut.first, cut.last});
        return;
    }
    std::vector<Interval> opaque;
    hideByMask(triangle, crossings, cut, opaque);
    std::for_each(opaque.begin(), opaque.end(), hide);
}

TriangleShadows::TriangleShadows(std::span<const PlacedSurface> surfaces,
                                 const MaterialTextures& textures) {
    std::vector<TreeTriangle> triangles;
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
        for (std::size_t t = 0; surfaces[s].castsShadow() && t < surfaces[s].triangles(); ++t) {
            triangles.push_back(
                {surfaces[s].cornerPositions(t), std::uint32_t(s), std::uint32_t(t)});
        }
    }
    tree_ = std::make_unique<Tree>(Tree{surfaces, textures, TriangleTree(std::move(triangles))});
}

TriangleShadows::~TriangleShadows() = default;

void TriangleShadows::findLit(const BeamSegment& segment, std::vector<Interval>& lit) const {
    thread_local std::vector<Interval> dark;
    dark.clear();
    const Fan fan(segment);
    const glm::dvec3& lamp = segment.lamp.light.frame.position;
    const TriangleTree& tree = tree_->tree;
    std::array<std::uint32_t, 64> stack{};  // halved evenly, so at most 32 deep
    std::size_t waiting = 0;
    if (!tree.boxes.empty()) {
        stack[waiting++] = 0;
    }
    while (waiting > 0) {
        const std::uint32_t index = stack[--waiting];
        const TriangleTree::Box& box = tree.boxes[index];
        if (!touches(fan, lamp, box)) {
            continue;
        }
        for (std::uint32_t i = 0; i < box.count; ++i) {
            tree_->hideByTriangle(fan, segment, tree.triangles[box.first + i], dark);
        }
        if (box.count == 0) {
            stack[waiting++] = box.first;
            stack[waiting++] = index + 1;
        }
    }
    invert(dark, lit);
}

}  // namespace ribalta
