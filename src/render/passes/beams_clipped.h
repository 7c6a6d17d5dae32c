// Beams, method `clipped`: one pass over the tiles that beams cover, all lamps of a pixel summed in
// single precision and written once.
#pragma once

#include <map>

#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/frame_plan.h"
#include "render/frame_targets.h"
#include "render/gpu_scene.h"

namespace ribalta {

class ClippedBeamsPass {
  public:
    ClippedBeamsPass();
    void draw(const BeamsWork& work, const GpuScene& gpuScene, const Texture2D& shadowMaps,
              const FrameTargets& targets);

  private:
    std::map<std::pair<PhaseFunction::Kind, bool>, Program>
        programs_;  ///< by phase function and separate output
    Handle<deleteVertexArray> vertexArray_;
    Handle<deleteSampler> depthSampler_;  ///< reads shadow maps as depths, without comparing
    Buffer settings_;
    Buffer tiles_;
    Buffer tileLamps_;
};

}  // namespace ribalta
