#include "render/beam_tiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ribalta {
namespace {

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
};

// The stretch of x that a convex outline covers between two heights.
Range coveredBetween(const std::vector<glm::dvec2>& outline, double bottom, double top) {
    Range range;
    const auto add = [&](double x) {
        range.low = std::min(range.low, x);
        range.high = std::max(range.high, x);
    };
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2& a = outline[i];
        const glm::dvec2& b = outline[(i + 1) % outline.size()];
        if (a.y >= bottom && a.y <= top) {
            add(a.x);
        }
        for (const double y : {bottom, top}) {
            if ((a.y < y) != (b.y < y)) {
                add(a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)));
            }
        }
    }
    return range;
}

int tileOf(double pixel, int tiles) {
    return int(std::clamp(std::floor(pixel / gpu::kTileSide), -1.0, double(tiles)));
}

}  // namespace

BeamTiles makeBeamTiles(const std::vector<std::vector<glm::dvec2>>& outlines, int width,
                        int height) {
    const int across = (width + gpu::kTileSide - 1) / gpu::kTileSide;
    const int down = (height + gpu::kTileSide - 1) / gpu::kTileSide;
    BeamTiles result;
    std::vector<std::vector<int>> row(static_cast<std::size_t>(across));
    for (int y = 0; y < down; ++y) {
        for (std::vector<int>& list : row) {
            list.clear();
        }
        for (std::size_t lamp = 0; lamp < outlines.size(); ++lamp) {
            // Half a pixel more on each side: an outline thinner than a pixel is still seen.
            const Range range = coveredBetween(outlines[lamp], y * gpu::kTileSide - 0.5,
                                               (y + 1) * gpu::kTileSide + 0.5);
            if (!(range.low <= range.high)) {
                continue;
            }
            const int first = std::max(0, tileOf(range.low - 0.5, across));
            const int last = std::min(across - 1, tileOf(range.high + 0.5, across));
            for (int x = first; x <= last; ++x) {
                row[std::size_t(x)].push_back(int(lamp));
            }
        }
        for (int x = 0; x < across; ++x) {
            const std::vector<int>& list = row[std::size_t(x)];
            if (!list.empty()) {
                result.tiles.push_back(
                    {glm::ivec4(x, y, int(result.lamps.size()), int(list.size()))});
                result.lamps.insert(result.lamps.end(), list.begin(), list.end());
            }
        }
    }
    return result;
}

}  // namespace ribalta
