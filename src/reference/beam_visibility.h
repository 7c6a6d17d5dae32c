// BeamVisibility: where along a ray a lamp's light arrives. What the answer rests on (a function,
// shadow maps, triangles) is for those who implement it.
#pragma once

#include <functional>
#include <vector>

#include <glm/glm.hpp>

#include "reference/beam_lamp.h"
#include "reference/interval.h"

namespace ribalta {

class BeamVisibility {
  public:
    virtual ~BeamVisibility() = default;

    /// Replaces `lit` by the stretches of the segment's x in [0, 1], ascending and apart, that the
    /// lamp's light reaches. Asked from several threads at once.
    virtual void findLit(const BeamSegment& segment, std::vector<Interval>& lit) const = 0;
};

/// Whether light of the lamp reaches a point in the world (metres). Asked from several threads at
/// once.
using LampVisibility = std::function<bool(const SpotLight& lamp, const glm::dvec3& point)>;

/// Visibility that can only be asked point by point.
class ProbedVisibility : public BeamVisibility {
  public:
    /// Asks at `probes` points of a segment, half of them even in distance, half in the lamp's
    /// projection, and follows changes between neighbours by bisection. A lit or dark stretch
    /// that falls between two neighbours is not seen.
    explicit ProbedVisibility(LampVisibility isVisible, int probes = 128);

    void findLit(const BeamSegment& segment, std::vector<Interval>& lit) const override;

  private:
    LampVisibility isVisible_;
    int probes_;
};

}  // namespace ribalta
