// loadGltf: a .gltf or .glb file into a Scene. The only door into this module.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "base/report.h"
#include "gltf/load_options.h"
#include "scene/scene.h"

namespace ribalta {

struct LoadedScene {
    Scene scene;
    Report report;
    std::vector<std::filesystem::path> files;    ///< the file itself, and the images beside it
    std::vector<std::string> extensionsUsed;     ///< as the file lists them
    std::vector<std::string> extensionsIgnored;  ///< of these, what this program does not draw
    std::vector<std::string> sceneNames;         ///< of all the file's scenes; may be empty
    int sceneIndex = -1;                         ///< of these, the one loaded; -1: there is none

    /// Wall time of a step of loading, in order: parse, meshes, images, ...
    struct Stage {
        std::string name;
        double ms;
    };
    std::vector<Stage> stages;
};

/// Loads the scene that the options ask for: else the file's default, or its first one, or all root
/// nodes where it has none. Images and Draco meshes are decoded in parallel. Throws
/// Error(kBadInput) with a place where the file cannot be used; what can be drawn in spite of a
/// fault is, and the report says so. Throws Error(kUsage) that lists the file's scenes where the
/// one asked for is not among them.
LoadedScene loadGltf(const std::filesystem::path& path, const LoadOptions& options = {});

}  // namespace ribalta
