// Beams, method `planes`: the thesis's own (Pessoa 2007). For each lamp all sampling planes, over
// the whole view, cut by the surfaces and added one upon another.
#pragma once

#include <map>
#include <tuple>

#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/frame_plan.h"
#include "render/frame_targets.h"
#include "render/gpu_scene.h"

namespace ribalta {

class PlaneBeamsPass {
  public:
    PlaneBeamsPass();
    void draw(const BeamsWork& work, const GpuScene& gpuScene, const Texture2D& shadowMaps,
              const FrameTargets& targets);

  private:
    /// By phase function, separate output and whether the smooth factor is evaluated on cells.
    std::map<std::tuple<PhaseFunction::Kind, bool, bool>, Program> programs_;
    Handle<deleteVertexArray> vertexArray_;
    Buffer settings_;
};

}  // namespace ribalta
