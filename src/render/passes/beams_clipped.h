// Beams, methods `clipped` and `march`: one pass over the tiles that beams cover, at every pixel.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "gl/program.h"
#include "gl/texture.h"
#include "render/frame_plan.h"
#include "render/frame_targets.h"
#include "render/gpu_scene.h"
#include "render/sheet_inputs.h"

namespace ribalta {

class ClippedBeamsPass {
  public:
    void draw(const BeamsWork& work, const GpuScene& gpuScene, const ShadowTextures& shadows,
              const FrameTargets& targets);
    /// Of the last draw, which was told to count them.
    gpu::RunCounts runCounts() const { return inputs_.runCounts(); }

  private:
    /// By method and defines.
    std::map<std::pair<BeamMethod, std::vector<std::string>>, Program> programs_;
    SheetInputs inputs_;
};

}  // namespace ribalta
