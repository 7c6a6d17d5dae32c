// Beams, method `planes`: the thesis's own (Pessoa 2007). For each lamp all sampling planes, over
// the whole view, cut by the surfaces and added one upon another.
#pragma once

#include <map>
#include <tuple>

#include "gl/buffer.h"
#include "gl/framebuffer.h"
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
    void makeEightBitTarget(const FrameTargets& targets);
    /// Adds the eight-bit sum to the picture.
    void addEightBits(const BeamsWork& work, const FrameTargets& targets);

    /// By defines.
    std::map<std::vector<std::string>, Program> programs_;
    std::map<bool, Program> addPrograms_;  ///< by separate output; only for eight bits
    Texture2D codes_;                      ///< RGBA8; only for eight bits
    Framebuffer codesWithDepth_;
    GLuint depthOfCodes_ = 0;  ///< the depth texture it was made with
    Handle<deleteVertexArray> vertexArray_;
    Buffer settings_;
};

}  // namespace ribalta
