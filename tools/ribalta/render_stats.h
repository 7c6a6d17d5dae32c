// What a render took, as people read it and as JSON.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <shared/beams.h>

#include "gl/timer.h"
#include "gltf/load_gltf.h"
#include "render/frame_plan.h"

namespace ribalta {

/// One drawn frame: from planning to the last pixel, and its passes.
struct FrameTimes {
    double frameMs = 0.0;
    std::vector<PassTime> passes;
};

struct RenderStats {
    std::string plan;      ///< of the first frame
    std::string renderer;  ///< OpenGL's name of it
    std::vector<FrameTimes> frames;
    std::vector<LoadedScene::Stage> load;
    /// Of the last frame, unless said otherwise.
    int lampsDrawn = 0;
    int lampsSkipped = 0;
    SkippedLamps skipped;
    int lampsWithLightMap = 0;
    int beamsDrawn = 0;
    int tilesDrawn = 0;
    int tilesTotal = 0;
    int surfacesDrawn = 0;
    int surfacesCulled = 0;
    int shadowMapsNeedless = 0;
    int castersDrawn = 0;
    int castersCulled = 0;
    int sunCastersDrawn = 0;
    int sunCastersCulled = 0;
    int sunMapsDrawn = 0;               ///< over all frames
    int sunMapsKept = 0;                ///< over all frames
    int framesKept = 0;                 ///< over all frames
    int shadowMapsDrawn = 0;            ///< over all frames
    int shadowMapsKept = 0;             ///< over all frames
    int meshesDeformed = 0;             ///< over all frames: brought into another shape
    int meshesKept = 0;                 ///< over all frames: drawn in the shape that they had
    std::int64_t verticesDeformed = 0;  ///< over all frames
    std::uint64_t drawCalls = 0;        ///< over all frames
    std::uint64_t samples = 0;          ///< of the last frame
    gpu::RunCounts runs{};              ///< of a frame like the last
    std::uint64_t programsBuilt = 0;
    double firstPixelMs = 0.0;  ///< from the start of the process to the end of its first frame
    std::uint64_t texturesMade = 0;
    std::uint64_t uploadedBytes = 0;  ///< geometry, pictures and materials in OpenGL's memory
    std::uint64_t peakBytes = 0;
    std::optional<double> ev100;
};

/// The medians over the frames, pass by pass; a pass that only some frames had counts in those.
FrameTimes medianTimes(const std::vector<FrameTimes>& frames);

/// Takes over what the plan of the last frame says.
void countPlan(const FramePlan& plan, const Scene& scene, RenderStats& stats);

/// A table for people.
std::string describeTimes(const RenderStats& stats);

/// Writes the statistics as JSON; see the README for its keys. Throws Error(kJobFailed).
void writeStats(const std::filesystem::path& file, const RenderStats& stats);

}  // namespace ribalta
