#include "viewer/background_loader.h"

#include <exception>
#include <new>
#include <utility>

#include "base/error.h"
#include "viewer/window.h"

namespace ribalta {
namespace {

BackgroundLoader::Result read(const std::filesystem::path& path, const LoadOptions& options) {
    BackgroundLoader::Result result;
    result.path = path;
    try {
        result.scene = loadGltf(path, options);
    } catch (const std::bad_alloc&) {
        result.error = path.string() + ": out of memory";
    } catch (const std::exception& error) {
        result.error = oneLine(error.what());
    }
    return result;
}

}  // namespace

BackgroundLoader::~BackgroundLoader() = default;

void BackgroundLoader::begin(const std::filesystem::path& path) {
    reading_ = path;
    start_ = std::chrono::steady_clock::now();
    if (!first_) {
        first_ = path;
    }
    LoadOptions options = options_;
    if (path != *first_) {
        options.scene.reset();
    }
    thread_ = std::jthread([this, path, options] {
        Result result = read(path, options);
        {
            const std::scoped_lock lock(mutex_);
            result_ = std::move(result);
        }
        Window::wake();
    });
}

void BackgroundLoader::load(const std::filesystem::path& path) {
    if (reading_) {
        next_ = path;
    } else {
        begin(path);
    }
}

void BackgroundLoader::reload(const std::filesystem::path& path) {
    if (!next_ && (!reading_ || *reading_ == path)) {
        load(path);
    }
}

std::optional<BackgroundLoader::Result> BackgroundLoader::take() {
    std::optional<Result> result;
    {
        const std::scoped_lock lock(mutex_);
        result = std::exchange(result_, std::nullopt);
    }
    if (!result) {
        return result;
    }
    reading_.reset();
    if (next_) {
        begin(*std::exchange(next_, std::nullopt));
    }
    return result;
}

double BackgroundLoader::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

}  // namespace ribalta
