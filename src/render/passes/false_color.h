// False colours: the picture for a screen of a frame whose colours are illuminance.
#pragma once

#include "gl/program.h"
#include "render/frame_targets.h"
#include "render/gpu_scene.h"

namespace ribalta {

class FalseColorPass {
  public:
    FalseColorPass();
    /// The last colour stands for `highestLux`, > 0.
    void draw(double highestLux, const FrameTargets& targets);

  private:
    Program program_;
    Handle<deleteVertexArray> vertexArray_;
};

}  // namespace ribalta
