// Beams, methods `clipped` and `march`: one pass over the tiles that beams cover, at every pixel.
#pragma once

#include <map>
#include <tuple>

#include "gl/program.h"
#include "gl/texture.h"
#include "render/frame_plan.h"
#include "render/frame_targets.h"
#include "render/gpu_scene.h"
#include "render/sheet_inputs.h"

namespace ribalta {

class ClippedBeamsPass {
  public:
    void draw(const BeamsWork& work, const GpuScene& gpuScene, const Texture2D& shadowMaps,
              const FrameTargets& targets);

  private:
    /// By phase function, separate output and method.
    std::map<std::tuple<PhaseFunction::Kind, bool, BeamMethod>, Program> programs_;
    SheetInputs inputs_;
};

}  // namespace ribalta
