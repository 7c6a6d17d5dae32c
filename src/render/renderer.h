// Renderer: carries a frame plan out, pass by pass in its order. A pass is made when it first has
// work, so what a scene does not need compiles no shader and takes no memory.
#pragma once

#include <optional>
#include <vector>

#include "gl/timer.h"
#include "render/exposure_meter.h"
#include "render/frame_inputs.h"
#include "render/frame_plan.h"
#include "render/frame_targets.h"
#include "render/gpu_frame.h"
#include "render/gpu_scene.h"
#include "render/passes/beams_adaptive.h"
#include "render/passes/beams_clipped.h"
#include "render/passes/beams_planes.h"
#include "render/passes/deform.h"
#include "render/passes/false_color.h"
#include "render/passes/forward.h"
#include "render/passes/shadow_map.h"
#include "render/passes/shadow_pyramid.h"
#include "render/passes/sky.h"
#include "render/passes/sun_shadow.h"
#include "render/passes/tonemap.h"

namespace ribalta {

class Renderer {
  public:
    /// Uploads the scene, which must outlive the renderer. Needs a current context. The sky's
    /// tables are kept in `files` from one run to the next, where it is not null; it must outlive
    /// the renderer too.
    explicit Renderer(const Scene& scene, const FileCache* files = nullptr);

    /// Plans and draws a frame; the plan is that of the last frame until the next call. Where
    /// camera, settings, lamps and placements are those of the frame before, its picture is kept:
    /// nothing is planned or drawn, and the plan is the one before with `kept` set.
    const FramePlan& draw(const Camera& camera, const FrameSettings& settings);

    /// The times of the last frame's passes; waits for the GPU.
    std::vector<PassTime> takeTimes() { return timer_.take(); }
    const FramePlan& lastPlan() const { return plan_; }
    /// What the last frame was drawn into.
    const FrameTargets& targets() const { return *targets_; }
    /// The exposure of the last frame's display picture; none where there was none.
    std::optional<double> ev100() const;
    /// Lets the next call of draw() draw its passes even where nothing changed, as a measurement
    /// needs it. Shadow maps are kept as between any two frames.
    void redrawNextFrame() { drawn_.reset(); }
    /// Uploads pictures that the scene has got since it was uploaded, and draws all anew.
    void usePictures() {
        gpuScene_.usePictures(scene_);
        uploadedMaterials_ = materialNumbers(scene_);
        forget();
    }
    /// Draws the next frame and every one of its shadow maps anew.
    void forget() {
        cache_ = {};
        drawn_.reset();
    }

    /// What the shadow maps' pyramid told in the last frame; none where it was not used, or
    /// FrameSettings::countRuns not set.
    std::optional<gpu::RunCounts> runCounts() const;

    /// Light samples that the beams of the last frame took, sheets * pixels * lamps. Of `adaptive`
    /// only the GPU knows which pixels those were: waits for it.
    std::uint64_t beamSamples() const;

    /// The layers that the last plan's lamps name; empty where no lamp has casters.
    const Texture2D& shadowMaps() const;
    /// Their pyramid; empty until a frame has used one.
    const Texture2D& shadowPyramid() const;

  private:
    ShadowTextures shadows() const;
    void drawBeams(const BeamsWork& work);

    const Scene& scene_;
    const FileCache* const files_;
    LitRegions litRegions_;
    GpuScene gpuScene_;
    GpuFrame gpuFrame_;
    std::vector<glm::dvec4> uploadedMaterials_;  ///< their animated numbers as they were
    FrameCache cache_;
    std::optional<FrameInputs> drawn_;  ///< what the picture that is there was drawn from
    FramePlan plan_;
    PassTimer timer_;
    std::optional<FrameTargets> targets_;
    DrawCasters drawCasters_;
    std::optional<DeformPass> deform_;
    std::optional<ShadowMapPass> shadowMapPass_;
    std::optional<ShadowPyramidPass> shadowPyramidPass_;
    std::optional<ForwardPass> forward_;
    std::optional<SkyPass> sky_;
    std::optional<SunShadowPass> sunShadow_;
    std::optional<AdaptiveBeamsPass> adaptiveBeams_;
    std::optional<ClippedBeamsPass> clippedBeams_;
    std::optional<PlaneBeamsPass> planeBeams_;
    std::optional<ExposureMeter> exposure_;
    std::optional<TonemapPass> tonemap_;
    std::optional<FalseColorPass> falseColor_;
};

}  // namespace ribalta
