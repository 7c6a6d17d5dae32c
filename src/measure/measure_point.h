// MeasurePoint: how long frames of one kind take, and the light they show. Writes nothing.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "measure/rgb_picture.h"
#include "measure/sweep_record.h"
#include "render/renderer.h"

namespace ribalta {

struct MeasureSettings {
    int warmups = 2;                ///< frames that are drawn and not counted
    int repeats = 7;                ///< frames that are counted
    double maxPointSeconds = 60.0;  ///< for all frames of a point; at least one is counted
    /// Asked between frames; true ends the measurement by Interrupted.
    std::function<bool()> interrupted = [] { return false; };
};

/// What measurePoint throws when it was told to end.
struct Interrupted {};

/// Fills the record's times, samples, memory and counts of frames; `expectedSeconds` is what one
/// frame will probably take, where that is known. Where the limit leaves no room for all frames,
/// fewer are drawn and the record's message says so; where it leaves none for one, the record is
/// skipped.
void measureTimes(Renderer& renderer, const Camera& camera, const MeasureSettings& settings,
                  std::optional<double> expectedSeconds, SweepRecord& record);

/// The last frame's whole picture and its beams, in cd/m2.
struct DrawnLight {
    RgbPicture total;
    RgbPicture beams;
};
DrawnLight drawLight(Renderer& renderer, const Camera& camera, FrameSettings settings);

}  // namespace ribalta
