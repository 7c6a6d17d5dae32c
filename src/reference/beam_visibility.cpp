#include "reference/beam_visibility.h"

#include <algorithm>
#include <utility>

#include "reference/lit_stretches.h"

namespace ribalta {

ProbedVisibility::ProbedVisibility(LampVisibility isVisible, int probes)
    : isVisible_(std::move(isVisible)), probes_(probes) {}

void ProbedVisibility::findLit(const BeamSegment& segment, std::vector<Interval>& lit) const {
    std::vector<double> places;
    const int half = std::max(probes_ / 2, 2);
    for (int i = 0; i < half; ++i) {
        const double fraction = double(i) / (half - 1);
        places.push_back(fraction);
        places.push_back(segment.placeOf(segment.part.first + fraction * segment.part.length()));
    }
    std::sort(places.begin(), places.end());
    const SpotLight& lamp = segment.lamp.light;
    lit = litStretches(
        [&](double x) {
            return isVisible_(lamp, lamp.frame.position + segment.worldOrigin +
                                        segment.distanceAt(x) * segment.worldDirection);
        },
        places);
}

}  // namespace ribalta
