// What the methods that sample by sheets read: tiles and their lamps, settings, shadow and light
// maps, depths.
#pragma once

#include "gl/buffer.h"
#include "gl/pipeline_state.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/frame_plan.h"
#include "render/frame_targets.h"
#include "render/gpu_scene.h"

namespace ribalta {

class SheetInputs {
  public:
    SheetInputs();

    /// Uploads what `work` says and binds everything. unbind() after the draws.
    void bind(const BeamsWork& work, const GpuScene& gpuScene, const Texture2D& shadowMaps,
              const FrameTargets& targets);
    void unbind();

    /// Draws a square for each of the work's tiles.
    void drawTiles(const Program& program, Blend blend) const;

  private:
    Handle<deleteVertexArray> vertexArray_;
    Handle<deleteSampler> depthSampler_;  ///< reads shadow maps as depths, without comparing
    Buffer settings_;
    Buffer tiles_;
    Buffer tileLamps_;
    int tileCount_ = 0;
};

}  // namespace ribalta
