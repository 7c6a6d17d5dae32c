// A scene from its file, and what people are told about that.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "gltf/load_gltf.h"

namespace ribalta {

/// Loads a glTF file; warns of what was mended and of a scene without lamps, tells the rest of the
/// report with --verbose. Throws as loadGltf.
LoadedScene loadScene(const std::string& path, const LoadOptions& options);

/// The same on a thread of its own, in two steps: OpenGL starts while the file is read, and
/// geometry is uploaded while pictures are decoded.
class SceneAhead {
  public:
    /// Begins. What the options point to must outlive this.
    SceneAhead(std::string path, LoadOptions options);
    ~SceneAhead() = default;
    SceneAhead(const SceneAhead&) = delete;
    SceneAhead& operator=(const SceneAhead&) = delete;

    /// Waits for all but the pictures, which have no pixels yet. To be called once. Throws as
    /// loadScene.
    LoadedScene takeScene();
    /// Waits for pictures and puts those that are decoded into that scene; false when no more
    /// come. Throws as loadScene.
    bool takePictures(LoadedScene& loaded);

  private:
    // What the thread has for the others.
    struct Done {
        std::optional<LoadedScene> scene{};
        std::vector<std::pair<std::size_t, Image>> pictures{};  ///< with indices into Scene::images
        bool isAll = false;
        Report pictureReport{};  ///< there when that is all, as is the time
        std::optional<double> picturesMs{};
        std::exception_ptr fault{};
    };

    void read(const std::string& path, const LoadOptions& options, const std::stop_token& stop);
    /// Changes done_ and wakes who waits.
    template <typename Change>
    void tell(const Change& change);

    std::mutex mutex_;
    std::condition_variable came_;
    Done done_;            ///< guarded by mutex_
    std::jthread thread_;  ///< last: uses the above, and is ended first
};

}  // namespace ribalta
