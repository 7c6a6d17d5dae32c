// The frames of an animation, drawn one after the other by one renderer.
#pragma once

#include <functional>

#include "animation_options.h"
#include "render/renderer.h"
#include "render_outputs.h"

namespace ribalta {

/// What checkOutputs is for one picture, before any work is done: throws as that does, and where a
/// film cannot be made.
void checkFrameOutputs(const RenderOutputs& outputs, const FrameRange& range,
                       const FrameSettings& settings);

struct FramesJob {
    Scene& scene;  ///< the renderer's own; posed for every frame
    Renderer& renderer;
    Camera camera;           ///< goes with its node, and with its own animation
    FrameSettings settings;  ///< a sun that stands where the scene's lamp does goes with it
    const RenderOutputs& outputs;
    FrameRange range;
    int animation = kAllAnimations;
    bool fresh = false;  ///< pictures that are there are drawn anew
    /// Pictures that are older are drawn anew too: the scene or the look has changed since.
    std::filesystem::file_time_type newestInput = std::filesystem::file_time_type::min();
    std::function<void(Scene&)> afterPose = [](Scene&) {};  ///< what else is changed then
};

/// Draws and writes all frames whose pictures are not there and whole yet; a film takes all of
/// them. On an interrupt the frame at hand is finished and the process ended by the signal; what
/// is written stays, but for a film. Throws Error(kJobFailed).
void renderFrames(FramesJob job);

}  // namespace ribalta
