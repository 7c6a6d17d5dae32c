// What the methods that sample by sheets read: tiles and their lamps, settings, shadow and light
// maps, depths.
#pragma once

#include <shared/beams.h>

#include "gl/buffer.h"
#include "gl/pipeline_state.h"
#include "gl/program.h"
#include "gl/sampler.h"
#include "gl/texture.h"
#include "render/frame_plan.h"
#include "render/frame_targets.h"
#include "render/gpu_scene.h"

namespace ribalta {

/// The shadow maps, and their pyramid where BeamsWork::shadowPyramid says so.
struct ShadowTextures {
    const Texture2D* maps = nullptr;
    const Texture2D* pyramid = nullptr;
};

class SheetInputs {
  public:
    SheetInputs();

    /// Uploads what `work` says and binds everything. unbind() after the draws.
    void bind(const BeamsWork& work, const GpuScene& gpuScene, const ShadowTextures& shadows,
              const FrameTargets& targets);
    void unbind();
    /// What the draws between counted, where BeamsWork::countRuns; waits for the GPU.
    gpu::RunCounts runCounts() const;

    /// Draws a square for each of the work's tiles.
    void drawTiles(const Program& program, Blend blend) const;

  private:
    Handle<deleteVertexArray> vertexArray_;
    Handle<deleteSampler> depthSampler_;  ///< reads shadow maps as depths, without comparing
    Buffer settings_;
    Buffer tiles_;
    Buffer tileLamps_;
    Buffer runCounts_;
    int tileCount_ = 0;
};

}  // namespace ribalta
