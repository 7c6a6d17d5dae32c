// BackgroundLoader: reads scenes on a thread of its own, so that the window goes on: first all but
// the pictures, then those as they are decoded.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include "gltf/load_gltf.h"

namespace ribalta {

class BackgroundLoader {
  public:
    /// A scene; those of its pictures that follow have no pixels yet.
    struct SceneRead {
        std::filesystem::path path;
        LoadedScene scene;
    };
    /// A picture of the scene before.
    struct PictureDecoded {
        std::size_t index;  ///< into Scene::images
        Image image;
    };
    /// Nothing more comes of a file.
    struct End {
        std::filesystem::path path;
        Report report;          ///< of its pictures
        double imagesMs = 0.0;  ///< that they took
        std::string error;      ///< why it could not be read to its end; empty: it was
    };
    using Event = std::variant<SceneRead, PictureDecoded, End>;

    /// How files are read; the scene and the variant that are asked for are the first file's.
    explicit BackgroundLoader(LoadOptions options) : options_(std::move(options)) {}
    ~BackgroundLoader();
    BackgroundLoader(const BackgroundLoader&) = delete;
    BackgroundLoader& operator=(const BackgroundLoader&) = delete;

    /// Begins to read a file, or notes it as the next one where one is being read.
    void load(const std::filesystem::path& path) { load({path, false}); }
    /// The same of a scene that has changed, which then comes with its pictures; nothing where
    /// another one is already waited for.
    void reload(const std::filesystem::path& path);
    /// What has come since the last call, in order. Called regularly; Window::wake() tells when.
    std::vector<Event> take();
    /// What is being read, and for how long.
    const std::optional<std::filesystem::path>& reading() const { return reading_; }
    double seconds() const;

  private:
    struct Request {
        std::filesystem::path path;
        bool asAWhole = false;
    };

    void load(const Request& request);
    void begin(const Request& request);
    void read(const Request& request, const LoadOptions& options, const std::stop_token& stop);
    void readScene(const Request& request, const LoadOptions& options, const std::stop_token& stop,
                   End& end);
    void post(Event event);

    LoadOptions options_;
    std::optional<std::filesystem::path> first_;
    std::optional<std::filesystem::path> reading_;
    std::optional<Request> next_;
    std::chrono::steady_clock::time_point start_;
    std::mutex mutex_;
    std::vector<Event> events_;  ///< guarded by mutex_
    std::jthread thread_;        ///< last: uses the above
};

}  // namespace ribalta
