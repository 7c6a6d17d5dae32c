// DrawCasters: surfaces drawn as depths alone, for shadow maps of any projection.
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "gl/buffer.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "render/draw_list.h"
#include "render/gpu_scene.h"

namespace ribalta {

/// A texture array of reversed depths that compares when it is looked up: 1 where the point is as
/// near to the light as what is there, or nearer.
Texture2D makeShadowArray(const std::string& label, int side, int layers);

/// A shadow map to draw: `casters` are indices into the draw list, instances side by side.
struct CasterLayer {
    const Framebuffer* layer = nullptr;
    glm::dmat4 clipFromWorld{1.0};
    const std::vector<int>* casters = nullptr;
};

class DrawCasters {
  public:
    /// Clears the layers and draws their casters in reversed depth.
    void draw(const std::vector<CasterLayer>& layers, const Scene& scene,
              const std::vector<DrawItem>& draws, const GpuScene& gpuScene);

  private:
    void drawLayer(const CasterLayer& layer, std::size_t firstInstance, const Scene& scene,
                   const std::vector<DrawItem>& draws, const GpuScene& gpuScene,
                   GLuint vertexArray);

    Program solid_;
    Program masked_;
    Buffer instances_;
};

}  // namespace ribalta
