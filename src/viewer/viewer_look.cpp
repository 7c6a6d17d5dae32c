// Viewer's look: brought to the scene, saved, loaded, kept where it would be lost; and pictures.
#include <cstdio>
#include <utility>

#include "base/error.h"
#include "image/write_image.h"
#include "look/look_file.h"
#include "render/read_frame.h"
#include "viewer/paths.h"
#include "viewer/viewer_loop.h"

namespace ribalta {
namespace {

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

// Looks are told apart by what would be lost: where the camera stands is not.
Look withoutView(Look look) {
    look.camera.reset();
    look.size.reset();
    look.scene.clear();
    std::erase_if(look.lamps, [](const LampChange& change) { return change.isIdle(); });
    return look;
}

}  // namespace

// Brings the look's lamps to the scene, and takes back what cannot be brought.
void Viewer::bringLook() {
    error_.reset();  // it looks at the scene as it is
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
        follow(state_.view, stage_->posed(state_.view.camera));
    }
    broughtLook_ = state_.look;
    ++lampsNow_;
    if (stage_->files() != watched_) {
        watchFiles();
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

void Viewer::takeLook(Look look, const std::filesystem::path& file) {
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
}

void Viewer::loadLook(const std::filesystem::path& file, bool evenIfKept) {
    try {
        Look look = readLook(file);
        if (evenIfKept || look != keptLook_) {
            takeLook(std::move(look), file);
        }
    } catch (const std::exception& error) {
        state_.sayError(oneLine(error.what()) + " (the look stays as it was)");
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
    // Between frames of the window: see run().
    state_.requests.measureError = requests.measureError;
    state_.requests.chooseBeams = requests.chooseBeams;
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
        loadLook(state_.lookFile, true);
    }
    if (requests.savePicture && isComplete_) {
        savePicture();
    }
    // It waits for what of the scene is still being read.
    state_.requests.savePicture = requests.savePicture && !isComplete_;
}

}  // namespace ribalta
