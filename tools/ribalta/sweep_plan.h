// SweepPlan: which points a sweep has, from its options. Draws nothing.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gltf/load_gltf.h"
#include "look_options.h"
#include "measure/sweep_record.h"
#include "options.h"
#include "scene/camera.h"

namespace ribalta {

/// Sheet counts of "8:1024" (doubled), "8:64:8" (in steps), "8:1000:1.5x" (by a factor) or
/// "8,16,24"; rising, each once, 1..65536, at most 256 of them. Throws CLI::ValidationError that
/// names the limits.
std::vector<int> parsePlaneCounts(const std::string& text);

/// Methods of "all" or of names by comma. Throws CLI::ValidationError that lists them.
std::vector<BeamMethod> parseMethods(const std::string& text);

/// Tolerances by comma, 0..1, each once; none of an empty text. Throws CLI::ValidationError.
std::vector<double> parseTolerances(const std::string& text);

/// Sizes by comma, as parseSize, each once.
std::vector<PictureSize> parseSizes(const std::string& text);

/// A scene of a sweep, loaded or not.
struct SweepScene {
    std::string path;
    std::string hash;                   ///< of its content
    std::optional<LoadedScene> loaded;  ///< none: it cannot be used
    std::string wrong;                  ///< why not
};

/// Throws Error(kUsage) where two scenes go by one name: their records could not be told apart.
void refuseNamesakes(const std::vector<std::string>& paths);

/// Loads it and brings the look that is given; what is wrong with the scene is kept for its
/// records. Throws Error(kUsage) where the options ask for a scene that it does not have,
/// Error(kBadInput) where the look is at fault.
SweepScene loadSweepScene(const std::string& path, const LoadOptions& options,
                          const LookOptions& look);

struct PlannedPoint {
    SweepPoint point;
    std::size_t scene = 0;  ///< into SweepPlan::scenes
    Camera camera;
};

struct SweepPlan {
    std::vector<SweepScene> scenes;
    std::vector<PlannedPoint> points;  ///< view by view, in a view method by method, sheets rising
};

/// What every point shares, and what differs.
struct SweepGrid {
    std::vector<std::string> cameras;  ///< names or indices; "all"; none: each scene's first
    std::vector<PictureSize> sizes;
    std::vector<BeamMethod> methods;
    std::vector<int> planes;
    std::vector<double> tolerances;   ///< of `adaptive`; none: the renderer's own
    FrameSettings settings;           ///< haze, ambient light, exposure, tone curve
    std::optional<Camera> ownCamera;  ///< of a look; in place of each scene's first
    bool pessoa2007 = false;  ///< the thesis's settings in the place of planes, methods and haze
};

/// Every scene from every camera that it has. Throws Error(kUsage) where a scene has none of them,
/// where a camera is in no scene, or where the points are over 100,000.
SweepPlan planSweep(std::vector<SweepScene> scenes, const SweepGrid& grid);

}  // namespace ribalta
