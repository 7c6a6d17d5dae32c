// LiveQuality: how coarse a picture may be while things move, so that it keeps up with them. Counts
// milliseconds; knows no window and no OpenGL.
#pragma once

#include <glm/glm.hpp>

#include "render/frame_settings.h"

namespace ribalta {

class LiveQuality {
  public:
    static constexpr double kFrameMs = 1000.0 / 60.0;
    /// Sheets a beam while things move; fewer where the look itself has fewer.
    static constexpr int kSheets = 8;
    /// The picture is at least this share of the window each way.
    static constexpr double kCoarsest = 0.125;

    /// The still picture's settings, made coarse enough for movement.
    FrameSettings coarsened(const FrameSettings& still) const;
    /// What the last coarse frame took, in milliseconds.
    void took(double ms);
    /// Share of the window's pixels each way, kCoarsest..1.
    double scale() const { return scale_; }

  private:
    double scale_ = 0.5;
};

}  // namespace ribalta
