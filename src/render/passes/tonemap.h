// Tone mapping: the picture for a screen, exposed, tone mapped, sRGB-encoded and dithered.
#pragma once

#include "gl/program.h"
#include "render/frame_targets.h"
#include "render/gpu_scene.h"

namespace ribalta {

class TonemapPass {
  public:
    TonemapPass();
    /// The exposure must be bound to its slot.
    void draw(const FrameTargets& targets);

  private:
    Program program_;
    Handle<deleteVertexArray> vertexArray_;
};

}  // namespace ribalta
