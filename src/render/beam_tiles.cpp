#include "render/beam_tiles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

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

int tileOf(double pixel, int side, int tiles) {
    return int(std::clamp(std::floor(pixel / side), -1.0, double(tiles)));
}

}  // namespace

BeamTiles makeBeamTiles(const std::vector<std::vector<glm::dvec2>>& outlines, int width, int height,
                        int side) {
    const int across = (width + side - 1) / side;
    const int down = (height + side - 1) / side;
    BeamTiles result;
    result.side = side;
    std::vector<std::vector<int>> row(static_cast<std::size_t>(across));
    for (int y = 0; y < down; ++y) {
        for (std::vector<int>& list : row) {
            list.clear();
        }
        for (std::size_t lamp = 0; lamp < outlines.size(); ++lamp) {
            // Half a pixel more on each side: an outline thinner than a pixel is still seen.
            const Range range =
                coveredBetween(outlines[lamp], y * side - 0.5, (y + 1) * side + 0.5);
            if (!(range.low <= range.high)) {
                continue;
            }
            const int first = std::max(0, tileOf(range.low - 0.5, side, across));
            const int last = std::min(across - 1, tileOf(range.high + 0.5, side, across));
            for (int x = first; x <= last; ++x) {
                row[std::size_t(x)].push_back(int(lamp));
            }
        }
        for (int x = 0; x < across; ++x) {
            const std::vector<int>& list = row[std::size_t(x)];
            if (!list.empty()) {
                result.tiles.push_back(
                    {glm::ivec4(x, y, int(result.lamps.size()), int(list.size())), glm::ivec4(0)});
                result.lamps.insert(result.lamps.end(), list.begin(), list.end());
            }
        }
    }
    return result;
}

void markThinBeams(const std::vector<std::vector<glm::dvec2>>& outlines, int width, int height,
                   BeamTiles& tiles) {
    // Also the tiles around it: what lies beside a thin beam hides as well between points.
    const BeamTiles thin = makeBeamTiles(outlines, width, height, gpu::kTileSide);
    std::set<std::pair<int, int>> places;
    for (const gpu::BeamSquare& tile : thin.tiles) {
        places.emplace(tile.place.x, tile.place.y);
    }
    for (gpu::BeamSquare& tile : tiles.tiles) {
        const glm::ivec2 first = glm::ivec2(tile.place) * tiles.side / gpu::kTileSide;
        tile.detail.x = places.contains({first.x, first.y}) ? 1 : 0;
    }
}

BeamTiles oneLampEach(const BeamTiles& tiles) {
    BeamTiles result;
    result.side = tiles.side;
    result.lamps = tiles.lamps;
    for (const gpu::BeamSquare& tile : tiles.tiles) {
        for (int i = 0; i < tile.place.w; ++i) {
            result.tiles.push_back(
                {glm::ivec4(tile.place.x, tile.place.y, tile.place.z + i, 1), tile.detail});
        }
    }
    const auto lampOf = [&](const gpu::BeamSquare& tile) {
        return result.lamps[std::size_t(tile.place.z)];
    };
    std::stable_sort(
        result.tiles.begin(), result.tiles.end(),
        [&](const gpu::BeamSquare& a, const gpu::BeamSquare& b) { return lampOf(a) < lampOf(b); });
    return result;
}

}  // namespace ribalta
