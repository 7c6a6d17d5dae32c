// Viewer's scenes: what is opened, dropped, watched, and what is done when it changes or arrives.
#include <algorithm>
#include <cctype>
#include <utility>

#include "base/error.h"
#include "base/freed_memory.h"
#include "viewer/paths.h"
#include "viewer/viewer_loop.h"

namespace ribalta {
namespace {

// Another of the cameras that a reloaded scene has, by its name.
int nodeOfCamera(const Scene& scene, const Camera& camera) {
    for (const Camera& each : scene.cameras) {
        if (camera.node >= 0 && each.name == camera.name) {
            return each.node;
        }
    }
    return -1;
}

std::size_t countRepaired(const Report& report) {
    return std::size_t(std::count_if(
        report.entries().begin(), report.entries().end(),
        [](const Report::Entry& entry) { return entry.kind == Report::Kind::kRepaired; }));
}

}  // namespace

void Viewer::open(const std::filesystem::path& scene) {
    scenePath_ = scene;
    loader_.load(scene);
}

void Viewer::watchFiles() {
    watched_ = stage_ ? stage_->files() : std::vector<std::filesystem::path>();
    std::vector<std::filesystem::path> files = watched_;
    if (!scenePath_.empty() && !stage_) {
        files.push_back(scenePath_);
    }
    if (isThere(state_.lookFile)) {
        files.push_back(state_.lookFile);
    }
    files.insert(files.end(), shaders_.begin(), shaders_.end());
    watch_.watch(files);
}

void Viewer::takeLoaded() {
    std::vector<std::pair<std::size_t, Image>> pictures;
    for (BackgroundLoader::Event& event : loader_.take()) {
        if (auto* scene = std::get_if<BackgroundLoader::SceneRead>(&event)) {
            pictures.clear();
            show(std::move(*scene));
        } else if (auto* picture = std::get_if<BackgroundLoader::PictureDecoded>(&event)) {
            pictures.emplace_back(picture->index, std::move(picture->image));
        } else {
            tellOfEnd(std::get<BackgroundLoader::End>(event));
        }
    }
    if (stage_ && !pictures.empty()) {
        error_.reset();
        stage_->takePictures(std::move(pictures));
        bringLook();
    }
}

void Viewer::tellOfEnd(const BackgroundLoader::End& end) {
    returnFreedMemory();
    if (stage_ && stage_->path() == end.path && !isComplete_) {
        isComplete_ = true;
        if (stats_.scenesLoaded == 1) {
            stats_.load.push_back({"images", end.imagesMs});
        }
    }
    if (!end.error.empty()) {
        state_.sayError(end.error + (stage_ ? " (the scene stays as it was)" : ""));
        watchFiles();
        return;
    }
    if (const std::size_t missing = countRepaired(end.report); missing > 0) {
        state_.sayError(
            std::to_string(missing) +
            " pictures of the scene are missing or broken: `ribalta inspect` lists them");
    }
}

void Viewer::show(BackgroundLoader::SceneRead read) {
    const bool isSame = stage_ && plainPath(stage_->path()) == plainPath(read.path);
    const bool isFirst = stats_.scenesLoaded == 0;
    if (!isSame && !isFirst) {
        keepUnsavedLook();
    }
    const std::size_t repaired = countRepaired(read.scene.report);
    std::optional<LampId> selected;
    if (stage_ && state_.selected >= 0) {
        selected = stage_->lamps()[std::size_t(state_.selected)];
    }
    state_.selected = -1;
    state_.isPlaying = state_.isPlaying && isSame;
    std::vector<LoadedScene::Stage> stages = read.scene.stages;
    // The old one first: two scenes may be more than the GPU's memory holds.
    error_.reset();
    stage_.reset();
    try {
        stage_ = std::make_unique<StageView>(std::move(read.scene), read.path,
                                             options_.cache ? &*options_.cache : nullptr);
    } catch (const std::exception& error) {
        state_.isPlaying = false;
        state_.sayError(oneLine(error.what()));
        watchFiles();
        return;
    }
    if (isFirst) {
        stats_.load = std::move(stages);
    }
    ++stats_.scenesLoaded;
    isComplete_ = false;
    shownSince_ = Clock::now();
    if (isSame) {
        continueScene(selected);
    } else {
        beginScene(isFirst);
    }
    for (const std::string& lamp : lampsNotThere(state_.look.lamps, stage_->scene())) {
        state_.sayError("look: the scene has no lamp '" + lamp + "'");
    }
    window_.setTitle(read.path.filename().string() + " - ribalta");
    state_.say((isSame ? "reloaded " : "opened ") + read.path.filename().string() +
               (repaired == 0 ? ""
                              : "; " + std::to_string(repaired) +
                                    " things in it are mended: `ribalta inspect` lists them"));
    seenFrom_.reset();
    bringLook();
    watchFiles();
}

// The look that was asked for on the command line is the first scene's; another begins without.
void Viewer::beginScene(bool isFirst) {
    const double aspectRatio =
        double(std::max(1, window_.pixels().x)) / double(std::max(1, window_.pixels().y));
    if (!isFirst) {
        state_.look = Look{};
    }
    state_.look.scene = stage_->path().filename().string();
    const Camera camera =
        state_.look.camera ? *state_.look.camera : stage_->homeCamera(aspectRatio);
    state_.view = viewpointOf(camera, stage_->bounds());
    ownsLookFile_ = isFirst && !options_.lookFile.empty();
    state_.lookFile = ownsLookFile_ ? options_.lookFile : lookBeside(stage_->path());
    keptLook_ = state_.look;
    if (!ownsLookFile_ && isThere(state_.lookFile)) {
        state_.say("a look lies beside the scene: Ctrl+O loads " +
                   state_.lookFile.filename().string());
    }
}

// What was chosen is found again by name, since numbers may have changed.
void Viewer::continueScene(const std::optional<LampId>& selected) {
    state_.view.camera.node = nodeOfCamera(stage_->scene(), state_.view.camera);
    for (std::size_t i = 0; selected && i < stage_->lamps().size(); ++i) {
        const LampId& lamp = stage_->lamps()[i];
        if (lamp.name == selected->name && lamp.number == selected->number) {
            state_.selected = int(i);
        }
    }
}

void Viewer::renewShaders() {
    if (!stage_ || !hasPixels()) {
        return;
    }
    try {
        stage_->renewPrograms(state_.view.camera, stillSettings());
        seenFrom_.reset();
        state_.say("shaders are made anew");
    } catch (const std::exception& error) {
        state_.sayError(oneLine(error.what()) + " (the old shaders stay)");
    }
}

void Viewer::takeChanged() {
    bool sceneChanged = false;
    bool shadersChanged = false;
    for (const std::filesystem::path& file : watch_.takeChanged()) {
        if (!isThere(file)) {
            state_.sayError(file.string() + ": is gone" +
                            (stage_ ? " (the picture stays as it was)" : ""));
        } else if (plainPath(state_.lookFile) == file) {
            if (stage_) {
                // What the window itself wrote is what it shows.
                loadLook(state_.lookFile, false);
            }
        } else if (isAmong(file, shaders_)) {
            shadersChanged = true;
        } else if (stage_ && stage_->isLightMapOfLook(file)) {
            try {
                stage_->reloadLightMap(file);
                bringLook();
                state_.say("reloaded " + file.filename().string());
            } catch (const std::exception& error) {
                state_.sayError(oneLine(error.what()) + " (the picture stays as it was)");
            }
        } else {
            sceneChanged = true;
        }
    }
    if (shadersChanged) {
        renewShaders();
    }
    if (sceneChanged) {
        loader_.reload(stage_ ? stage_->path() : scenePath_);
    }
}

void Viewer::takeDropped() {
    for (const std::filesystem::path& file : window_.takeDropped()) {
        drop(file);
    }
}

void Viewer::drop(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    if (ending == ".gltf" || ending == ".glb") {
        open(file);
    } else if (!stage_) {
        state_.sayError(file.string() + ": is no scene; drop a .gltf or .glb file");
    } else if (ending == ".json") {
        loadLook(file, true);
    } else if (state_.selected < 0) {
        state_.sayError(file.string() + ": choose a lamp first, to give it this light map");
    } else {
        const LampId& lamp = stage_->lamps()[std::size_t(state_.selected)];
        if (lamp.kind == LampId::Kind::kSpot) {
            state_.changeOf(lamp).lightMap.file = plainPath(file);
        } else {
            state_.sayError("lamp '" + lamp.name + "' is no spot and takes no light map");
        }
    }
}

}  // namespace ribalta
