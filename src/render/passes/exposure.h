// Exposure: the EV100 that the tone mapping uses, given or found from the picture.
#pragma once

#include "gl/buffer.h"
#include "gl/program.h"
#include "render/frame_plan.h"
#include "render/frame_targets.h"

namespace ribalta {

class ExposurePass {
  public:
    void draw(const TonemapWork& work, const FrameTargets& targets);

    /// The EV100 of the last draw; waits for the GPU.
    double ev100() const;

  private:
    Program program_;  ///< made when an exposure is first looked for
    Buffer exposure_;
};

}  // namespace ribalta
