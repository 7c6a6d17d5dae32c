// The checks of one set-up drawn by one method: finite, not negative, right, and the same when the
// whole set-up is moved. The bounds and what they rest on: README.md of this folder.
#pragma once

#include <string>
#include <vector>

#include "stage.h"

namespace ribalta::stress {

struct Findings {
    std::vector<std::string> faults;  ///< one line each; empty: all is well
    double worstError = 0.0;          ///< of a pixel, relative to the brightest one looked at
    double worstMotion = 0.0;         ///< the same, between the set-up and the moved one
    /// The largest share of its bound that a pixel's error took, of those over plain rounding.
    double worstShare = 0.0;
    int pixels = 0;  ///< compared
};

Findings checkSetUp(const SetUp& setUp, BeamMethod method, Stage& stage);

/// How far the program's own reference integral is off in a few pixels.
Findings checkReference(const SetUp& setUp);

}  // namespace ribalta::stress
