// Beam tiles: which lamps' beams each square of the picture may show.
#pragma once

#include <vector>

#include <glm/glm.hpp>
#include <shared/beams.h>

namespace ribalta {

struct BeamTiles {
    int side = gpu::kTileSide;           ///< pixels
    std::vector<gpu::BeamSquare> tiles;  ///< those with at least one lamp, row by row from below
    std::vector<int> lamps;              ///< the tiles' lists, one after another
};

/// `outlines[i]` is the convex outline of the beam of lamp i in pixels (see beamOutline), or empty;
/// `side` that of a tile in pixels.
BeamTiles makeBeamTiles(const std::vector<std::vector<glm::dvec2>>& outlines, int width, int height,
                        int side = gpu::kTileSide);

/// Marks the tiles that one of `outlines` touches as showing a thin beam.
void markThinBeams(const std::vector<std::vector<glm::dvec2>>& outlines, int width, int height,
                   BeamTiles& tiles);

/// The same with a tile of its own for each of a tile's lamps, lamp after lamp.
BeamTiles oneLampEach(const BeamTiles& tiles);

}  // namespace ribalta
