// loadGltf: a .gltf or .glb file into a Scene. The only door into this module.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "base/report.h"
#include "scene/scene.h"

namespace ribalta {

struct LoadedScene {
    Scene scene;
    Report report;
    std::vector<std::filesystem::path> files;    ///< the file itself, and the images beside it
    std::vector<std::string> extensionsUsed;     ///< as the file lists them
    std::vector<std::string> extensionsIgnored;  ///< of these, what this program does not draw

    /// Wall time of a step of loading, in order: parse, meshes, images, ...
    struct Stage {
        std::string name;
        double ms;
    };
    std::vector<Stage> stages;
};

/// Loads the file's default scene, or its first one, or all root nodes where it has none.
/// Images and Draco meshes are decoded in parallel. Throws Error(kBadInput) with a place where the
/// file cannot be used; what can be drawn in spite of a fault is, and the report says so.
LoadedScene loadGltf(const std::filesystem::path& path);

}  // namespace ribalta
