// DrawCasters: surfaces drawn as depths alone, for shadow maps of any projection.
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "render/draw_list.h"
#include "render/gpu_scene.h"

namespace ribalta {

/// A texture array of reversed depths that compares when it is looked up: 1 where the point is as
/// near to the light as what is there, or nearer.
Texture2D makeShadowArray(const std::string& label, int side, int layers);

class DrawCasters {
  public:
    /// Clears the layer and draws `casters`, indices into `draws`, in reversed depth.
    void draw(const Framebuffer& layer, const glm::dmat4& clipFromWorld,
              const std::vector<int>& casters, const Scene& scene,
              const std::vector<DrawItem>& draws, const GpuScene& gpuScene);

  private:
    Program solid_;
    Program masked_;
};

}  // namespace ribalta
