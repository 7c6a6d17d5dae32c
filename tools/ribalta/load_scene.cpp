#include "load_scene.h"

#include <chrono>

#include "base/log.h"
#include "base/progress.h"

namespace ribalta {
namespace {

void tellOf(const Report& report) {
    for (const Report::Entry& entry : report.entries()) {
        const std::string line =
            std::string(name(entry.kind)) + ": " + entry.place.text() + ": " + entry.message;
        // What is mended changes the picture and is always said; the rest is for --verbose, and
        // for `ribalta inspect`.
        if (entry.kind == Report::Kind::kRepaired) {
            logWarning(line);
        } else {
            logVerbose(line);
        }
    }
}

void tellOfScene(const LoadedScene& loaded) {
    tellOf(loaded.report);
    const Scene& scene = loaded.scene;
    if (scene.spotLights.empty() && scene.pointLights.empty() && scene.directionalLights.empty() &&
        !scene.environment) {
        logWarning("the scene has no lamps; only ambient light is drawn (see --ambient)");
    }
}

LoadedScene load(const std::string& path, const LoadOptions& options) {
    const Progress progress("loading");
    return loadGltf(path, options);
}

}  // namespace

LoadedScene loadScene(const std::string& path, const LoadOptions& options) {
    LoadedScene loaded = load(path, options);
    tellOfScene(loaded);
    return loaded;
}

SceneAhead::SceneAhead(std::string path, LoadOptions options)
    : thread_([this, path = std::move(path),
               options = std::move(options)](const std::stop_token& stop) {
          try {
              read(path, options, stop);
          } catch (...) {
              tell([](Done& done) { done.fault = std::current_exception(); });
          }
          tell([](Done& done) { done.isAll = true; });
      }) {}

template <typename Change>
void SceneAhead::tell(const Change& change) {
    {
        const std::scoped_lock lock(mutex_);
        change(done_);
    }
    came_.notify_one();
}

void SceneAhead::read(const std::string& path, const LoadOptions& options,
                      const std::stop_token& stop) {
    std::optional<Progress> progress(std::in_place, "loading");
    GltfLoad load(path, options);
    progress.reset();
    tell([&](Done& done) { done.scene = load.takeScene(); });
    const auto start = std::chrono::steady_clock::now();
    Report report = load.decodeImages([&](std::size_t index, Image image) {
        tell([&](Done& done) { done.pictures.emplace_back(index, std::move(image)); });
        return !stop.stop_requested();
    });
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    tell([&](Done& done) {
        done.pictureReport = std::move(report);
        done.picturesMs = took.count();
    });
}

LoadedScene SceneAhead::takeScene() {
    std::unique_lock lock(mutex_);
    came_.wait(lock, [&] { return done_.scene || done_.isAll; });
    if (!done_.scene) {
        std::rethrow_exception(done_.fault);
    }
    LoadedScene loaded = std::move(*done_.scene);
    lock.unlock();
    tellOfScene(loaded);
    return loaded;
}

bool SceneAhead::takePictures(LoadedScene& loaded) {
    std::unique_lock lock(mutex_);
    came_.wait(lock, [&] { return !done_.pictures.empty() || done_.isAll; });
    const bool haveCome = !done_.pictures.empty();
    for (auto& [index, image] : std::exchange(done_.pictures, {})) {
        loaded.scene.images[index] = std::move(image);
    }
    if (haveCome) {
        return true;
    }
    if (done_.fault) {
        std::rethrow_exception(done_.fault);
    }
    if (done_.picturesMs) {
        loaded.stages.push_back({"images", *done_.picturesMs});
        loaded.report.append(done_.pictureReport);
        tellOf(done_.pictureReport);
        done_.picturesMs.reset();
    }
    return false;
}

}  // namespace ribalta
