// BackgroundLoader: reads scenes on a thread of its own, so that the window goes on.
#pragma once

#include <chrono>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "gltf/load_gltf.h"

namespace ribalta {

class BackgroundLoader {
  public:
    /// What came of a load: a scene, or what was wrong.
    struct Result {
        std::filesystem::path path;
        std::optional<LoadedScene> scene;
        std::string error;  ///< where there is no scene
    };

    /// How files are read; the `scene` that is asked for is one of the first file.
    explicit BackgroundLoader(LoadOptions options) : options_(std::move(options)) {}
    ~BackgroundLoader();
    BackgroundLoader(const BackgroundLoader&) = delete;
    BackgroundLoader& operator=(const BackgroundLoader&) = delete;

    /// Begins to read a file, or notes it as the next one where one is being read.
    void load(const std::filesystem::path& path);
    /// The same of a scene that has changed; nothing where another one is already waited for.
    void reload(const std::filesystem::path& path);
    /// The scene that has been read since the last call, if any. Called regularly; Window::wake()
    /// tells when.
    std::optional<Result> take();
    /// What is being read, and for how long.
    const std::optional<std::filesystem::path>& reading() const { return reading_; }
    double seconds() const;

  private:
    void begin(const std::filesystem::path& path);

    LoadOptions options_;
    std::optional<std::filesystem::path> first_;
    std::optional<std::filesystem::path> reading_;
    std::optional<std::filesystem::path> next_;
    std::chrono::steady_clock::time_point start_;
    std::mutex mutex_;
    std::optional<Result> result_;  ///< guarded by mutex_
    std::jthread thread_;           ///< last: uses the above
};

}  // namespace ribalta
