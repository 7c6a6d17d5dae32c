// GpuFrame: what the shaders know of one frame: the view, its lamps and where things stand in it.
#pragma once

#include "gl/buffer.h"
#include "render/frame_plan.h"
#include "render/gpu_scene.h"
#include "render/sky_lighting.h"

namespace ribalta {

class GpuFrame {
  public:
    /// Uploads the plan's view, lamps and placements, and binds them to their slots. `daylight`:
    /// its sun is one more directional lamp; null where there is no sky.
    void upload(const Scene& scene, const FramePlan& plan, const GpuScene& gpuScene,
                const SkyLighting* daylight);

    /// A gpu::SurfaceInstance for each of the plan's opaque surfaces, then each blended one.
    const Buffer& surfaces() const { return surfaces_; }

  private:
    Buffer view_;
    Buffer spotLamps_;
    Buffer spotCones_;
    Buffer pointLamps_;
    Buffer directionalLamps_;
    Buffer surfaces_;
};

/// Clip space of a spot's shadow map from world: reversed depth, near / z.
glm::dmat4 shadowClipFromWorld(const SpotLight& lamp, int side);

}  // namespace ribalta
