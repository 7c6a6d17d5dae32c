// TriangleShadows: where along a view ray triangles keep a lamp's light away, with exact edges. The
// lamp and the ray span a plane; a triangle cuts it in a line, and what that line hides of the ray
// is an interval whose ends follow from its own. No ray is cast, no point probed.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "reference/beam_visibility.h"
#include "reference/material_textures.h"
#include "reference/placed_surface.h"

namespace ribalta {

class TriangleShadows : public BeamVisibility {
  public:
    /// Of the surfaces that cast shadows. Keeps references to both arguments. Masked surfaces let
    /// light through their holes; nothing nearer to a lamp than its lens plane casts.
    TriangleShadows(std::span<const PlacedSurface> surfaces, const MaterialTextures& textures);
    ~TriangleShadows() override;
    TriangleShadows(const TriangleShadows&) = delete;
    TriangleShadows& operator=(const TriangleShadows&) = delete;

    void findLit(const BeamSegment& segment, std::vector<Interval>& lit) const override;

  private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

}  // namespace ribalta
