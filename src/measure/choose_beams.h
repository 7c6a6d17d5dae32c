// ChooseBeams: the method and number of sheets that reach a time or an error on this machine, in
// this view. Found by drawing it, not by a formula.
#pragma once

#include <functional>
#include <optional>

#include "render/renderer.h"

namespace ribalta {

/// What is to be reached: a time, or else an error.
struct BeamGoal {
    std::optional<double> budgetMs;  ///< GPU time of the beams in a frame
    double errorPercent = 0.5;       ///< tone-mapped RMSE in % of full scale; without a budget
};

struct BeamChoice {
    BeamSettings beams;
    double beamsMs = 0.0;       ///< GPU time of the beams, median of a few frames at full size
    double errorPercent = 0.0;  ///< against many sheets, in a picture half as wide and high
    bool reached = false;       ///< otherwise it is the nearest there is
};

/// Tries `adaptive` and `clipped` with numbers of sheets from a fixed ladder, halving the ladder
/// each time. Times are those of the whole picture; errors, at the exposure of `settings` or one
/// found, those of one half as wide and high, where they are a little larger. Draws some twenty
/// frames, and calls `betweenFrames` before each; what that throws ends the search.
BeamChoice chooseBeams(
    Renderer& renderer, const Camera& camera, const FrameSettings& settings, const BeamGoal& goal,
    const std::function<void()>& betweenFrames = [] {});

}  // namespace ribalta
