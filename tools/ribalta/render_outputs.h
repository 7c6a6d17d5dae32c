// The files a render writes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reference/sky_sight.h"
#include "render/frame_settings.h"
#include "render/read_frame.h"
#include "render/renderer.h"

namespace ribalta {

/// What `-o`, `--aov` and `--stats` ask for.
struct RenderOutputs {
    std::vector<std::filesystem::path> files;
    FrameLayers layers;
    std::filesystem::path stats;  ///< empty: none

    /// Whether any file shows the frame as a screen does, or there is no file.
    bool wantsDisplay() const;
    bool wantsExr() const;
};

/// Before any work is done, throws Error(kUsage) for an ending that says no format and for layers
/// that no file holds, Error(kJobFailed) for a folder that is not there or cannot be written.
void checkOutputs(const RenderOutputs& outputs);

/// "beams,depth" into layers; throws CLI::ValidationError that lists them.
FrameLayers parseLayers(const std::string& text);

/// The sky that a drawing's model stands for, with the orders that the model has.
SkyOverScene skyOf(const SkyDrawing& drawing);

/// Writes the renderer's last frame; an .exr says which sky is over it. Throws Error(kJobFailed).
void writeOutputs(const RenderOutputs& outputs, const FramePlan& plan, const FrameTargets& targets);

}  // namespace ribalta
