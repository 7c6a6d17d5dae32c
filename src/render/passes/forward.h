// Forward shading: every visible surface under all lamps, opaque near to far, blended far to near.
#pragma once

#include <map>

#include "gl/program.h"
#include "gl/texture.h"
#include "render/frame_plan.h"
#include "render/frame_targets.h"
#include "render/gpu_frame.h"
#include "render/gpu_scene.h"

namespace ribalta {

class ForwardPass {
  public:
    /// `shadowMaps` may be empty where no lamp has casters.
    void draw(const ForwardWork& work, const Scene& scene, const FramePlan& plan,
              const GpuScene& gpuScene, const GpuFrame& frame, const Texture2D& shadowMaps,
              const FrameTargets& targets);

  private:
    struct Variant {
        bool textures = false;
        bool alphaMask = false;
        bool normalOutput = false;
        bool sky = false;
        bool sunShadow = false;
        bool illuminance = false;
        bool layers = false;
        bool seenThrough = false;  ///< what is behind is tinted, and nothing added

        auto operator<=>(const Variant&) const = default;
    };

    void drawItem(const Scene& scene, const FramePlan& plan, const GpuScene& gpuScene,
                  const GpuFrame& frame, int index, bool blended, bool normalOutput,
                  bool seenThrough = false);
    const Program& program(const Variant& variant);

    std::map<Variant, Program> programs_;
};

}  // namespace ribalta
