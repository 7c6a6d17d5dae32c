// Viewer's files: scenes that are read, looks that are kept, pictures that are saved, and what is
// done when one of them changes.
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <utility>

#include "base/error.h"
#include "image/write_image.h"
#include "look/look_file.h"
#include "render/read_frame.h"
#include "viewer/viewer_loop.h"

namespace ribalta {
namespace {

bool isThere(const std::filesystem::path& file) {
    std::error_code failed;
    return !file.empty() && std::filesystem::exists(file, failed);
}

std::filesystem::path plain(const std::filesystem::path& file) {
    std::error_code failed;
    const std::filesystem::path absolute = std::filesystem::absolute(file, failed);
    return (failed ? file : absolute).lexically_normal();
}

bool isAmong(const std::filesystem::path& file, const std::vector<std::filesystem::path>& files) {
    return std::any_of(files.begin(), files.end(), [&](const std::filesystem::path& each) {
        return plain(each) == plain(file);
    });
}

// Where a look lies unless it is said: beside its scene.
std::filesystem::path lookBeside(const std::filesystem::path& scene) {
    std::filesystem::path file = scene;
    return file.replace_extension(".look.json");
}

// The first of NAME_001.png, NAME_002.png, ... that is not there.
std::filesystem::path freePicture(const std::filesystem::path& folder, const std::string& name) {
    for (int number = 1;; ++number) {
        char end[24];
        std::snprintf(end, sizeof end, "_%03d.png", number);
        std::filesystem::path file = folder / (name + end);
        if (!isThere(file)) {
            return file;
        }
    }
}

// Another of the cameras that a reloaded scene has, by its name.
int nodeOfCamera(const Scene& scene, const Camera& camera) {
    for (const Camera& each : scene.cameras) {
        if (camera.node >= 0 && each.name == camera.name) {
            return each.node;
        }
    }
    return -1;
}

// Looks are told apart by what would be lost: where the camera stands is not.
Look withoutView(Look look) {
    look.camera.reset();
    look.size.reset();
    look.scene.clear();
    std::erase_if(look.lamps, [](const LampChange& change) { return change.isIdle(); });
    return look;
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
    watch_.watch(files);
}

void Viewer::takeLoaded() {
    if (std::optional<BackgroundLoader::Result> result = loader_.take()) {
        show(std::move(*result));
    }
}

void Viewer::show(BackgroundLoader::Result result) {
    if (!result.scene) {
        state_.sayError(result.error + (stage_ ? " (the scene stays as it was)" : ""));
        watchFiles();
        return;
    }
    const bool isSame = stage_ && plain(stage_->path()) == plain(result.path);
    const bool isFirst = stats_.scenesLoaded == 0;
    if (!isSame && !isFirst) {
        keepUnsavedLook();
    }
    const auto repaired = std::count_if(
        result.scene->report.entries().begin(), result.scene->report.entries().end(),
        [](const Report::Entry& entry) { return entry.kind == Report::Kind::kRepaired; });
    std::optional<LampId> selected;
    if (stage_ && state_.selected >= 0) {
        selected = stage_->lamps()[std::size_t(state_.selected)];
    }
    state_.selected = -1;
    state_.isPlaying = state_.isPlaying && isSame;
    std::vector<LoadedScene::Stage> stages = result.scene->stages;
    // The old one first: two scenes may be more than the GPU's memory holds.
    stage_.reset();
    try {
        stage_ = std::make_unique<StageView>(std::move(*result.scene), result.path,
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
    if (isSame) {
        continueScene(selected);
    } else {
        beginScene(isFirst);
    }
    for (const std::string& lamp : lampsNotThere(state_.look.lamps, stage_->scene())) {
        state_.sayError("look: the scene has no lamp '" + lamp + "'");
    }
    window_.setTitle(result.path.filename().string() + " - ribalta");
    state_.say((isSame ? "reloaded " : "opened ") + result.path.filename().string() +
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

// Brings the look's lamps to the scene, and takes back what cannot be brought.
void Viewer::bringLook() {
    // Each failure takes one file back, or all of them.
    for (std::size_t tries = 0; tries <= state_.look.lamps.size() + 1; ++tries) {
        try {
            stage_->bring(state_.look);
            break;
        } catch (const std::exception& error) {
            state_.sayError(oneLine(error.what()));
            const auto* named = dynamic_cast<const Error*>(&error);
            const std::string file = named == nullptr ? "" : named->place().file;
            bool found = false;
            for (LampChange& change : state_.look.lamps) {
                if (change.lightMap.file && !file.empty() &&
                    change.lightMap.file->string() == file) {
                    change.lightMap.file.reset();
                    found = true;
                }
            }
            for (LampChange& change : state_.look.lamps) {
                if (!found && change.lightMap.file && !change.lightMap.file->empty()) {
                    change.lightMap.file.reset();
                }
            }
        }
    }
    if (state_.look.time && !knowsAnimation(*state_.look.time, stage_->scene()) &&
        state_.look.time != broughtLook_.time) {
        state_.sayError("look: the scene has no animation '" + state_.look.time->animation +
                        "'; all of them are played");
    }
    if (state_.look.time != broughtLook_.time) {
        follow(state_.view, stage_->posed(state_.view.camera).frame);
    }
    broughtLook_ = state_.look;
    ++lampsNow_;
    if (stage_->files() != watched_) {
        watchFiles();
    }
}

void Viewer::takeChanged() {
    bool sceneChanged = false;
    for (const std::filesystem::path& file : watch_.takeChanged()) {
        if (!isThere(file)) {
            state_.sayError(file.string() + ": is gone" +
                            (stage_ ? " (the picture stays as it was)" : ""));
        } else if (plain(state_.lookFile) == file) {
            reloadLook();
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
        loadLook(file);
    } else if (state_.selected < 0) {
        state_.sayError(file.string() + ": choose a lamp first, to give it this light map");
    } else {
        const LampId& lamp = stage_->lamps()[std::size_t(state_.selected)];
        if (lamp.kind == LampId::Kind::kSpot) {
            state_.changeOf(lamp).lightMap.file = plain(file);
        } else {
            state_.sayError("lamp '" + lamp.name + "' is no spot and takes no light map");
        }
    }
}

void Viewer::saveLook() {
    const std::filesystem::path& file = state_.lookFile;
    if (file.empty() || isAmong(file, stage_->files())) {
        state_.sayError(file.empty() ? "give the look a file name to save it"
                                     : file.string() + ": is read by the scene and not replaced");
        return;
    }
    state_.isPlaying = false;
    Look look = state_.look;
    std::erase_if(look.lamps, [](const LampChange& change) { return change.isIdle(); });
    look.scene = stage_->path().filename().string();
    look.camera = state_.view.camera;
    if (hasPixels()) {
        look.size = window_.pixels();
    }
    try {
        if (!ownsLookFile_ && isThere(file)) {
            std::filesystem::copy_file(file, file.string() + "~",
                                       std::filesystem::copy_options::overwrite_existing);
            state_.say("what was there is kept as " + file.filename().string() + "~");
        }
        writeLook(look, file);
        // What the file says, to the last digit, is what is shown from now on.
        keptLook_ = readLook(file);
        ownsLookFile_ = true;
        state_.look = keptLook_;
        const int node = state_.view.camera.node;
        state_.view.camera = *keptLook_.camera;
        state_.view.camera.node = node;
        state_.say("saved " + file.string());
    } catch (const std::exception& error) {
        state_.sayError(oneLine(error.what()));
    }
}

void Viewer::loadLook(const std::filesystem::path& file) {
    try {
        Look look = readLook(file);
        for (const std::string& lamp : lampsNotThere(look.lamps, stage_->scene())) {
            state_.sayError("look: the scene has no lamp '" + lamp + "'");
        }
        if (look.camera) {
            state_.view = viewpointOf(*look.camera, stage_->bounds());
        }
        keepUnsavedLook();
        keptLook_ = look;
        state_.look = std::move(look);
        state_.lookFile = file;
        ownsLookFile_ = true;
        state_.say("loaded " + file.string());
        watchFiles();
    } catch (const std::exception& error) {
        state_.sayError(oneLine(error.what()) + " (the look stays as it was)");
    }
}

// What the window itself wrote is what it shows.
void Viewer::reloadLook() {
    try {
        if (readLook(state_.lookFile) == keptLook_) {
            return;
        }
    } catch (const Error&) {
        // Told by loadLook().
    }
    if (stage_) {
        loadLook(state_.lookFile);
    }
}

// What was changed and not saved goes into a file of its own before it goes from the window.
void Viewer::keepUnsavedLook() {
    if (withoutView(state_.look) == withoutView(keptLook_) || state_.lookFile.empty()) {
        return;
    }
    const std::filesystem::path file = state_.lookFile.string() + "~";
    try {
        Look look = state_.look;
        look.camera = state_.view.camera;
        writeLook(look, file);
        state_.say("what was changed and not saved is kept in " + file.string());
    } catch (const std::exception& error) {
        state_.sayError(oneLine(error.what()));
    }
}

void Viewer::savePicture() {
    if (!hasPixels()) {
        state_.sayError("the window has no pixels to save");
        return;
    }
    try {
        drawStill(stillSettings());
        const std::filesystem::path file =
            freePicture(options_.pictures, stage_->path().stem().string());
        writePng(file, facts_.size.x, facts_.size.y, readDisplay(stage_->renderer().targets()));
        state_.say("saved " + file.string());
    } catch (const std::exception& error) {
        state_.sayError(oneLine(error.what()));
    }
}

void Viewer::carryOut(ViewerRequests requests) {
    state_.requests = {};
    if (requests.quit) {
        window_.close();
    }
    if (requests.reload && !scenePath_.empty()) {
        loader_.reload(stage_ ? stage_->path() : scenePath_);
    }
    if (!stage_) {
        return;
    }
    if (requests.saveLook) {
        saveLook();
        watchFiles();
    }
    if (requests.loadLook) {
        loadLook(state_.lookFile);
    }
    if (requests.savePicture) {
        savePicture();
    }
}

}  // namespace ribalta
