#include "viewer/background_loader.h"

#include <exception>
#include <new>

#include "base/error.h"
#include "viewer/window.h"

namespace ribalta {

BackgroundLoader::~BackgroundLoader() = default;

void BackgroundLoader::post(Event event) {
    {
        const std::scoped_lock lock(mutex_);
        events_.push_back(std::move(event));
    }
    Window::wake();
}

void BackgroundLoader::readScene(const Request& request, const LoadOptions& options,
                                 const std::stop_token& stop, End& end) {
    if (request.asAWhole) {
        post(SceneRead{request.path, loadGltf(request.path, options)});
        return;
    }
    GltfLoad load(request.path, options);
    post(SceneRead{request.path, load.takeScene()});
    const auto start = std::chrono::steady_clock::now();
    end.report = load.decodeImages([&](std::size_t index, Image image) {
        post(PictureDecoded{index, std::move(image)});
        return !stop.stop_requested();
    });
    end.imagesMs =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void BackgroundLoader::read(const Request& request, const LoadOptions& options,
                            const std::stop_token& stop) {
    End end;
    end.path = request.path;
    try {
        readScene(request, options, stop, end);
    } catch (const std::bad_alloc&) {
        end.error = request.path.string() + ": out of memory";
    } catch (const std::exception& error) {
        end.error = oneLine(error.what());
    }
    post(std::move(end));
}

void BackgroundLoader::begin(const Request& request) {
    reading_ = request.path;
    start_ = std::chrono::steady_clock::now();
    if (!first_) {
        first_ = request.path;
    }
    LoadOptions options = options_;
    if (request.path != *first_) {
        options.scene.reset();
        options.variant.reset();
    }
    thread_ = std::jthread(
        [this, request, options](const std::stop_token& stop) { read(request, options, stop); });
}

void BackgroundLoader::load(const Request& request) {
    if (reading_) {
        next_ = request;
    } else {
        begin(request);
    }
}

void BackgroundLoader::reload(const std::filesystem::path& path) {
    if (!next_ && (!reading_ || *reading_ == path)) {
        load({path, true});
    }
}

std::vector<BackgroundLoader::Event> BackgroundLoader::take() {
    std::vector<Event> events;
    {
        const std::scoped_lock lock(mutex_);
        events = std::exchange(events_, {});
    }
    if (!events.empty() && std::holds_alternative<End>(events.back())) {
        reading_.reset();
        if (next_) {
            begin(*std::exchange(next_, std::nullopt));
        }
    }
    return events;
}

double BackgroundLoader::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

}  // namespace ribalta
