// ShadowMapVisibility: where along a view ray drawn shadow maps keep a lamp's light away. Not
// filtered: each texel is what a sample of the beams looks up, so edges are the texels' own and
// exact.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "reference/beam_visibility.h"
#include "reference/reference_picture.h"

namespace ribalta {

class ShadowMapVisibility : public BeamVisibility {
  public:
    /// One map for each of the integrator's lamps, which they must outlive; none: no shadow.
    explicit ShadowMapVisibility(std::span<const std::optional<DrawnShadowMap>> maps)
        : maps_(maps) {}

    void findLit(const BeamSegment& segment, std::vector<Interval>& lit) const override;

  private:
    std::span<const std::optional<DrawnShadowMap>> maps_;
};

}  // namespace ribalta
