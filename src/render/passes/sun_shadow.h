// Sun shadow: what the sun sees of the scene, one layer of an array a cascade, and where the
// cascades lie in the view.
#pragma once

#include <vector>

#include "gl/buffer.h"
#include "gl/sampler.h"
#include "render/frame_plan.h"
#include "render/passes/draw_casters.h"

namespace ribalta {

class SunShadowPass {
  public:
    SunShadowPass();

    /// Draws the cascades that are not kept.
    void draw(const SunShadowWork& work, const Scene& scene, const FramePlan& plan,
              const GpuScene& gpuScene, DrawCasters& casters);
    /// Binds the maps and their uniform block for surfaces.
    void bind(const SunShadowWork& work, const FramePlan& plan);

  private:
    Texture2D maps_;
    std::vector<Framebuffer> layers_;
    Handle<deleteSampler> depthSampler_;  ///< reads the maps as depths, without comparing
    Buffer frame_;
};

}  // namespace ribalta
