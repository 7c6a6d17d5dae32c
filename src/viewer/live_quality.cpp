#include "viewer/live_quality.h"

#include <algorithm>
#include <cmath>

namespace ribalta {
namespace {

// Scales come in steps, so that the pictures' memory is not made anew in every frame.
constexpr double kStep = 0.125;
// Room for what the window itself takes, and for a frame that is a little slower than the last.
constexpr double kAimMs = 0.8 * LiveQuality::kFrameMs;
// A finer picture is tried only where it should keep the time with certainty.
constexpr double kSureMs = 0.9 * kAimMs;

}  // namespace

FrameSettings LiveQuality::coarsened(const FrameSettings& still) const {
    FrameSettings settings = still;
    settings.width = std::max(1, int(std::lround(still.width * scale_)));
    settings.height = std::max(1, int(std::lround(still.height * scale_)));
    if (settings.beams.planes > kSheets) {
        settings.beams.planes = kSheets;
        settings.beams.tolerance.reset();
    }
    return settings;
}

void LiveQuality::took(double ms) {
    if (!(ms > 0.0)) {
        return;
    }
    // Time goes with the number of pixels, or grows less than that.
    const double finer = std::min(1.0, scale_ + kStep);
    const double finerMs = ms * (finer / scale_) * (finer / scale_);
    if (ms > kAimMs) {
        const double wanted = scale_ * std::sqrt(kAimMs / ms);
        scale_ = std::clamp(std::floor(wanted / kStep) * kStep, kCoarsest, 1.0);
    } else if (finerMs < kSureMs) {
        scale_ = finer;
    }
}

}  // namespace ribalta
