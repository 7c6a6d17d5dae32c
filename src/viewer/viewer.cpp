#include "viewer/viewer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "base/error.h"
#include "gl/counters.h"
#include "gl/debug_output.h"
#include "gl/shader_library.h"
#include "look/look_settings.h"
#include "optics/photometry.h"
#include "viewer/viewer_loop.h"

namespace ribalta {
namespace {

// How long the first picture waits for pictures on surfaces and in lamps that are still being read.
constexpr double kPatienceSeconds = 0.2;
// How long nothing must have moved before the picture is refined.
constexpr double kRestSeconds = 0.15;

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Viewer::Viewer(ViewerOptions options)
    : options_(std::move(options)),
      window_("ribalta", options_.look.size.value_or(options_.size)),
      loader_(options_.loading) {
    state_.look = options_.look;
    state_.showPanels = options_.showPanels;
    facts_.renderer = window_.renderer();
    stats_.renderer = window_.renderer();
    if (!options_.shaders.empty()) {
        readShadersFrom(options_.shaders);
        for (const auto& entry : std::filesystem::recursive_directory_iterator(options_.shaders)) {
            shaders_.push_back(entry.path());
        }
    }
    if (options_.scene) {
        open(*options_.scene);
    }
}

std::string Viewer::busy() const {
    if (loader_.reading()) {
        char text[64];
        std::snprintf(text, sizeof text, "   %.0f s", loader_.seconds());
        return "reading " + loader_.reading()->filename().string() + text;
    }
    return stage_ ? "" : "drop a glTF scene (.gltf, .glb) on this window";
}

std::string Viewer::probe() const {
    const glm::ivec2 window = window_.pixels();
    if (!stage_ || !stage_->hasPicture() || !facts_.isStill || pointer_.isOverPanels()) {
        return {};
    }
    const glm::dvec2 share = (pointer_.at() + 0.5) / glm::dvec2(glm::max(window, glm::ivec2(1)));
    if (share.x < 0.0 || share.y < 0.0 || share.x >= 1.0 || share.y >= 1.0) {
        return {};
    }
    char text[96];
    std::snprintf(text, sizeof text, state_.highestLux ? "%.4g lx" : "%.4g cd/m2",
                  luminance(stage_->lightAt(stage_->pixelAt(share))));
    return text;
}

FrameSettings Viewer::stillSettings() const {
    FrameSettings settings = frameSettings(state_.look, stage_->scene());
    const glm::ivec2 size = window_.pixels();
    if (state_.highestLux) {
        settings.illuminance = IlluminanceView{*state_.highestLux};
    }
    settings.width = std::max(1, size.x);
    settings.height = std::max(1, size.y);
    return settings;
}

void Viewer::drawStill(const FrameSettings& still) {
    const FramePlan& plan = stage_->draw(state_.view.camera, still);
    (plan.kept ? stats_.picturesKept : stats_.picturesDrawn) += 1;
    if (!plan.kept) {
        facts_.passes = stage_->takeTimes();
    }
    if (isComplete_ && stats_.wholePictureMs == 0.0) {
        stats_.wholePictureMs = 1000.0 * secondsSince(options_.start);
    }
    facts_.isStill = true;
    facts_.framesPerSecond = 0.0;
    facts_.size = {still.width, still.height};
    facts_.sheets = still.beams.planes;
    facts_.ev100 = stage_->renderer().ev100();
}

double Viewer::patienceSeconds() const {
    return isComplete_ ? 0.0 : std::max(0.0, kPatienceSeconds - secondsSince(shownSince_));
}

void Viewer::drawPicture() {
    const FrameSettings still = stillSettings();
    const bool moves = seenFrom_ != state_.view || seenAs_ != still || lampsSeen_ != lampsNow_;
    // The first picture is drawn as it is to be; after that, what changes is shown at once.
    const bool isFirst = !seenFrom_.has_value();
    if (isFirst && patienceSeconds() > 0.0) {
        return;
    }
    if (moves) {
        movedAt_ = Clock::now();
        failed_ = false;
        error_.reset();
    }
    if (failed_) {
        return;
    }
    seenFrom_ = state_.view;
    seenAs_ = still;
    lampsSeen_ = lampsNow_;
    const bool rests = secondsSince(movedAt_) >= kRestSeconds && !pointer_.isWalking();
    if (isFirst || rests) {
        drawStill(still);
        if (stats_.firstPictureMs == 0.0) {
            stats_.firstPictureMs = 1000.0 * secondsSince(options_.start);
        }
        return;
    }
    if (moves) {
        drawMoving(still);
    }
}

void Viewer::drawMoving(const FrameSettings& still) {
    const Clock::time_point begin = Clock::now();
    const auto programsBefore = glCounters().programsBuilt;
    const FrameSettings coarse = quality_.coarsened(still);
    stage_->draw(state_.view.camera, coarse);
    facts_.passes = stage_->takeTimes();
    // What it takes to make a program says nothing of the frames to come.
    if (glCounters().programsBuilt == programsBefore) {
        quality_.took(1000.0 * secondsSince(begin));
    }
    ++stats_.picturesDrawn;
    facts_.isStill = false;
    const double between = secondsSince(lastMove_);
    facts_.framesPerSecond = between < 1.0 ? 1.0 / std::max(1e-3, between) : 0.0;
    lastMove_ = begin;
    facts_.size = {coarse.width, coarse.height};
    facts_.sheets = coarse.beams.planes;
    facts_.ev100 = stage_->renderer().ev100();
}

void Viewer::drawInterface() {
    window_.beginFrame();
    const std::vector<KeyPress> keys = window_.takeKeys();
    if (stage_) {
        pointer_.steer(keys, state_, *stage_, window_.pixels(), window_.pixelScale());
        facts_.probe = probe();
        facts_.error = errorSoFar();
        drawLegend(state_);
        drawPanels(state_, *stage_, facts_);
    }
    handleKeys(keys, state_, stage_.get(), window_.pixels());
    drawHelp(state_);
    drawMessages(state_, busy());
}

// Nothing needs drawing: until something comes. Otherwise until the picture is to be refined.
double Viewer::secondsToWait() const {
    // Nothing is to be seen in a window without pixels, which shows frames as fast as they come.
    constexpr double kUnseenSeconds = 0.05;
    if (unsettled_ > 0 || pointer_.isWalking() || state_.isPlaying) {
        return hasPixels() ? 0.0 : kUnseenSeconds;
    }
    double seconds = std::numeric_limits<double>::infinity();
    if (stage_ && !facts_.isStill && !failed_ && hasPixels()) {
        seconds = std::max({1e-3, kRestSeconds - secondsSince(movedAt_), patienceSeconds()});
    }
    for (const ViewerMessage& message : state_.messages) {
        const std::chrono::duration<double> left = message.until - Clock::now();
        seconds = std::min(seconds, std::max(1e-3, left.count()));
    }
    const bool isMeasuring = error_ && !error_->value().isDone;
    return loader_.reading() || isMeasuring ? std::min(seconds, 0.25) : seconds;
}

void Viewer::playOn() {
    const double elapsed = secondsSince(std::exchange(lastFrame_, Clock::now()));
    // The first frame after a pause shows the moment at which it was paused.
    const bool played = std::exchange(played_, state_.isPlaying);
    if (stage_ && state_.isPlaying) {
        state_.play(played ? elapsed : 0.0, stage_->durationSeconds(state_.look));
    }
}

ViewerStats Viewer::run() {
    while (!window_.isClosing()) {
        const bool came = window_.takeEvents(secondsToWait());
        unsettled_ = came ? kSettlingFrames : std::max(0, unsettled_ - 1);
        takeLoaded();
        takeChanged();
        takeDropped();
        drawInterface();
        carryOut(state_.requests);
        playOn();
        if (stage_ && state_.look != broughtLook_) {
            bringLook();
        }
        if (stage_ && hasPixels()) {
            try {
                drawPicture();
            } catch (const std::exception& error) {
                failed_ = true;
                state_.sayError(oneLine(error.what()));
            }
        }
        const bool hasPicture = stage_ && stage_->hasPicture();
        window_.showFrame(hasPicture ? stage_->renderer().targets().screen.name() : 0, facts_.size);
        ++stats_.framesShown;
        measure(ViewerRequests(state_.requests));
        stats_.glErrors += takeGlErrors().size();
    }
    if (stage_) {
        keepUnsavedLook();
    }
    // A scene that is still being read is read to its end, out of sight.
    window_.hide();
    return stats_;
}

ViewerStats runViewer(ViewerOptions options) {
    Viewer viewer(std::move(options));
    return viewer.run();
}

}  // namespace ribalta
