// Beams, method `adaptive`: sampled on a lattice of pixels, interpolated between its points, and
// sampled anew in the cells where that would show. Compute shaders but for the interpolation.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/exposure_meter.h"
#include "render/frame_plan.h"
#include "render/frame_targets.h"
#include "render/gpu_scene.h"
#include "render/sheet_inputs.h"

namespace ribalta {

class AdaptiveBeamsPass {
  public:
    AdaptiveBeamsPass();
    void draw(const BeamsWork& work, const GpuScene& gpuScene, const ShadowTextures& shadows,
              const FrameTargets& targets);
    /// Of the last draw, which was told to count them.
    gpu::RunCounts runCounts() const { return inputs_.runCounts(); }

  private:
    struct Programs {
        Program lattice;
        Program fill;
        Program samples;
    };

    Programs& programsFor(const BeamsWork& work);
    void makeLattice(const glm::ivec2& points);
    void findCells(const BeamsWork& work, const FrameTargets& targets);
    void sampleCells(const BeamsWork& work, const Program& program, const FrameTargets& targets);

    /// By defines.
    std::map<std::vector<std::string>, Programs> programs_;
    Program cells_;
    ExposureMeter exposure_;  ///< what the screen will show is not known before the beams are drawn
    SheetInputs inputs_;
    Texture2D latticeMap_;  ///< cd/m2; alpha: metres along the ray to the end of the last beam
    Texture2D cellsMap_;    ///< 1: sampled anew
    Buffer sampledCells_;
};

}  // namespace ribalta
