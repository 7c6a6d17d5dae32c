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

    // Instances drawn by one call.
    struct Run {
        int draw = 0;                   // the first of them, into FramePlan::draws
        std::size_t firstInstance = 0;  // into GpuFrame::surfaces
        std::size_t instances = 1;
        bool blended = false;
        bool seenThrough = false;  // as Variant's
    };
    void drawRun(const Scene& scene, const FramePlan& plan, const GpuScene& gpuScene,
                 GLuint vertexArray, const Run& run);
    const Program& program(const Variant& variant);

    std::map<Variant, Program> programs_;
};

}  // namespace ribalta
