// Adaptive integration of a colour over stretches of a line. Knows of no light.
#pragma once

#include <functional>
#include <span>

#include <glm/glm.hpp>

#include "reference/interval.h"

namespace ribalta {

/// How exact an integral is asked to be, and how much work that may take.
struct IntegralAccuracy {
    double relative = 1e-6;  ///< of the value's largest channel
    double absolute = 0.0;   ///< in the value's unit; the looser of the two counts
    int firstPieces = 8;     ///< the stretches are cut into about so many before looking at errors
    int maxPieces = 100000;  ///< gives up here; the error then says how far it came
};

struct Integral {
    glm::dvec3 value{0.0};
    /// Estimate for the worst channel, in the value's unit; far too high where the integrand is
    /// smooth between the stretches' ends, too low at times where it has kinks there.
    double error = 0.0;
    int evaluations = 0;  ///< of the integrand
};

/// The integral of `integrand` over `stretches` (ascending, without overlap): Gauss-Kronrod (7, 15)
/// on pieces, the worst halved until the sum of the errors is small enough. Kinks and jumps of
/// the integrand belong on the ends of stretches.
Integral integrateAdaptively(const std::function<glm::dvec3(double)>& integrand,
                             std::span<const Interval> stretches,
                             const IntegralAccuracy& accuracy = {});

}  // namespace ribalta
