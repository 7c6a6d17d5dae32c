// loadGltf: a .gltf or .glb file into a Scene. The only door into this module.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
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
    std::vector<std::string> variantNames;       ///< of its material variants; may be empty
    int sceneIndex = -1;                         ///< of these, the one loaded; -1: there is none

    /// Meshes that were found decoded in LoadOptions::cache.
    std::size_t meshesFromCache = 0;

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
/// fault is, and the report says so. Throws Error(kUsage) that lists the file's scenes or
/// variants where the one asked for is not among them.
LoadedScene loadGltf(const std::filesystem::path& path, const LoadOptions& options = {});

/// The same in two steps, for who shows the geometry before the pictures are decoded.
class GltfLoad {
  public:
    /// Reads all but the pictures. Throws as loadGltf does.
    explicit GltfLoad(const std::filesystem::path& path, const LoadOptions& options = {});
    ~GltfLoad();
    GltfLoad(const GltfLoad&) = delete;
    GltfLoad& operator=(const GltfLoad&) = delete;

    /// What was read, to be taken once: Scene::images have names and no pixels yet.
    LoadedScene takeScene();
    /// Decodes the pictures in parallel and hands each with its index into Scene::images to
    /// `take`, from any thread; in the place of one that is missing or broken the visible
    /// stand-in. Begins no more of them once `take` returns false. Returns what there is to report
    /// of them.
    Report decodeImages(const std::function<bool(std::size_t, Image)>& take) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace ribalta
