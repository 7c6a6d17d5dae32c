// Adaptive integration of a colour along a line with lit and dark stretches. Knows of no light.
#pragma once

#include <functional>
#include <span>

#include <glm/glm.hpp>

namespace ribalta {

/// How exact an integral is asked to be, and how much work that may take.
struct IntegralAccuracy {
    double relative = 1e-6;  ///< of the value's largest channel
    double absolute = 0.0;   ///< in the value's unit; the looser of the two counts
    int firstPieces = 8;     ///< the line is cut into at least so many before looking at errors
    int maxPieces = 4000;    ///< gives up here; the error then says how far it came
};

struct Integral {
    glm::dvec3 value{0.0};
    double error =
        0.0;  ///< estimate for the worst channel, in the value's unit; usually far too high
    int evaluations = 0;  ///< of the integrand
};

/// The integral of `integrand` over the parts of [ends.front(), ends.back()] where `lit` holds.
/// `ends` ascends and holds every place where the integrand is known to have a kink. An empty
/// `lit` is lit everywhere.
///
/// Gauss-Kronrod (7, 15) on pieces, the worst halved until the sum of the errors is small enough.
/// `lit` is asked at every node and at the ends of every piece, and each change between neighbours
/// is followed by bisection to 1e-12 of the whole line. A lit or dark stretch that falls between
/// all nodes of a piece is not seen: with firstPieces = n it must be shorter than 1 / (9 n) of the
/// line.
Integral integrateLit(const std::function<glm::dvec3(double)>& integrand,
                      const std::function<bool(double)>& lit, std::span<const double> ends,
                      const IntegralAccuracy& accuracy = {});

}  // namespace ribalta
