// Shadow maps: what each lamp sees of the scene, one layer of an array a lamp.
#pragma once

#include <vector>

#include "gl/framebuffer.h"
#include "gl/texture.h"
#include "render/frame_plan.h"
#include "render/gpu_scene.h"
#include "render/passes/draw_casters.h"

namespace ribalta {

class ShadowMapPass {
  public:
    void draw(const std::vector<ShadowMapWork>& work, const Scene& scene, const FramePlan& plan,
              const GpuScene& gpuScene, DrawCasters& casters);

    /// The layers; none until the first draw.
    const Texture2D& maps() const { return maps_; }

  private:
    void makeLayers(const ShadowMaps& wanted);

    Texture2D maps_;
    std::vector<Framebuffer> layers_;
};

}  // namespace ribalta
