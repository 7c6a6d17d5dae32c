// Beams, method `adaptive`: sampled on a lattice of pixels and interpolated between its points;
// where that would show, on a lattice twice as fine; and where that would show too, at every pixel.
// Compute shaders but for the interpolation.
#pragma once

#include <cstdint>
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
    /// Of the last draw, which was of `work` into so many pixels: pixels and points of the lattices
    /// that were sampled, each as often as it has lamps. Reads the lists of squares back; waits for
    /// the GPU.
    std::uint64_t sampledPixelLamps(const BeamsWork& work, glm::ivec2 picture) const;

  private:
    struct Programs {
        Program lattice;
        Program fine;
        Program fill;
        Program samples;
    };

    Programs& programsFor(const BeamsWork& work);
    void makeMaps(const BeamsWork& work, const FrameTargets& targets);
    void drawLattice(const BeamsWork& work, const Program& program) const;
    void drawFineLattice(const BeamsWork& work, const Program& program);
    void findQuads(const BeamsWork& work);
    void fillPicture(const BeamsWork& work, const Programs& programs,
                     const FrameTargets& targets) const;

    /// By defines.
    std::map<std::vector<std::string>, Programs> programs_;
    Program cells_;
    Program quads_;
    ExposureMeter exposure_;  ///< what the screen will show is not known before the beams are drawn
    SheetInputs inputs_;
    Texture2D latticeMap_;  ///< cd/m2; alpha: metres along the ray to the end of the last beam
    Texture2D fineMap_;     ///< the same at the finer lattice's points
    Texture2D quadsMap_;    ///< 1: sampled at every pixel
    Buffer sampledCells_;
    Buffer sampledQuads_;
};

}  // namespace ribalta
