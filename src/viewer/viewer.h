// The window's main loop: `ribalta view`.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>

#include <glm/glm.hpp>

#include "base/file_cache.h"
#include "gltf/load_gltf.h"
#include "look/look.h"

namespace ribalta {

struct ViewerOptions {
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    std::optional<std::filesystem::path> scene;  ///< none: one is dropped on the window
    LoadOptions loading;                         ///< its scene and variant are the first file's
    Look look;                                   ///< to begin with
    std::filesystem::path lookFile;              ///< empty: beside the scene
    glm::ivec2 size{1280, 720};                  ///< of the window, unless the look has one
    std::optional<FileCache> cache;
    bool showPanels = true;          ///< to begin with
    std::filesystem::path pictures;  ///< folder for pictures; empty: where the program runs
    /// Folder that shaders are read from, anew whenever one changes; empty: those of the build.
    std::filesystem::path shaders;
};

/// What a person waited for, and what the window did by itself.
struct ViewerStats {
    std::string renderer;
    double firstPictureMs = 0.0;           ///< since ViewerOptions::start; 0: none was drawn
    double wholePictureMs = 0.0;           ///< the same of the first with all the scene's pictures
    std::vector<LoadedScene::Stage> load;  ///< of the first scene
    std::uint64_t picturesDrawn = 0;       ///< of the scene
    std::uint64_t picturesKept = 0;        ///< shown again as they were
    std::uint64_t framesShown = 0;         ///< with panels, of either kind
    std::uint64_t scenesLoaded = 0;
    std::uint64_t glErrors = 0;
};

/// Shows the window until it is closed. Throws Error(kNoOpenGL) where none can be opened; what goes
/// wrong later is said in the window.
ViewerStats runViewer(ViewerOptions options);

}  // namespace ribalta
