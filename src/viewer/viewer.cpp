#include "viewer/viewer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "base/error.h"
#include "base/log.h"
#include "gl/counters.h"
#include "gl/debug_output.h"
#include "image/write_image.h"
#include "look/look_file.h"
#include "look/look_settings.h"
#include "optics/photometry.h"
#include "render/read_frame.h"
#include "viewer/background_loader.h"
#include "viewer/lamp_marks.h"
#include "viewer/live_quality.h"
#include "viewer/panels.h"
#include "viewer/pointer.h"
#include "viewer/stage_view.h"
#include "viewer/watch_files.h"
#include "viewer/window.h"

namespace ribalta {
namespace {

using Clock = std::chrono::steady_clock;

// How long nothing must have moved before the picture is refined.
constexpr double kRestSeconds = 0.15;
// Frames of panels after the last event, until they have settled.
constexpr int kSettlingFrames = 3;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
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
        const std::filesystem::path file = folder / (name + end);
        if (!std::filesystem::exists(file)) {
            return file;
        }
    }
}

class Viewer {
  public:
    explicit Viewer(ViewerOptions options);

    ViewerStats run();

  private:
    void takeLoaded();
    void takeChanged();
    void takeDropped();
    void drop(const std::filesystem::path& file);
    void show(BackgroundLoader::Result result);
    void bringLook();
    void carryOut(ViewerRequests requests);
    void saveLook();
    void loadLook();
    void reloadLook();
    void savePicture();
    void watchFiles();

    void drawInterface();
    void drawPicture();
    void drawStill(const FrameSettings& still);
    void playOn();
    double secondsToWait() const;
    std::string busy() const;
    std::string probe() const;
    FrameSettings stillSettings() const;

    ViewerOptions options_;
    Window window_;
    FileWatch watch_;
    BackgroundLoader loader_;
    std::unique_ptr<StageView> stage_;
    ViewerState state_;
    std::vector<std::filesystem::path> watched_;  ///< of the scene and its light maps
    Clock::time_point lastFrame_ = Clock::now();
    bool played_ = false;  ///< in the frame before
    Look broughtLook_;
    Look savedLook_;  ///< as the look's file has it, where the window wrote it
    Pointer pointer_;
    LiveQuality quality_;
    PictureFacts facts_;
    ViewerStats stats_;

    // What the last picture was asked for with, and since when that has been so.
    std::optional<Viewpoint> seenFrom_;
    std::optional<FrameSettings> seenAs_;
    std::uint64_t lampsSeen_ = 0;
    std::uint64_t lampsNow_ = 0;
    Clock::time_point movedAt_;
    Clock::time_point lastMove_;
    int unsettled_ = kSettlingFrames;
};

Viewer::Viewer(ViewerOptions options)
    : options_(std::move(options)), window_("ribalta", options_.look.size.value_or(options_.size)) {
    state_.look = options_.look;
    state_.showPanels = options_.showPanels;
    facts_.renderer = window_.renderer();
    stats_.renderer = window_.renderer();
    if (options_.scene) {
        loader_.load(*options_.scene);
    }
}

void Viewer::watchFiles() {
    watched_ = stage_->files();
    std::vector<std::filesystem::path> files = watched_;
    if (!state_.lookFile.empty() && std::filesystem::exists(state_.lookFile)) {
        files.push_back(state_.lookFile);
    }
    watch_.watch(files);
}

void Viewer::show(BackgroundLoader::Result result) {
    if (!result.scene) {
        state_.sayError(result.error + (stage_ ? " (the scene stays as it was)" : ""));
        return;
    }
    const bool isSame = stage_ && stage_->path() == result.path;
    const std::size_t repaired = std::count_if(
        result.scene->report.entries().begin(), result.scene->report.entries().end(),
        [](const Report::Entry& entry) { return entry.kind == Report::Kind::kRepaired; });
    if (stats_.scenesLoaded == 0) {
        stats_.load = result.scene->stages;
    }
    ++stats_.scenesLoaded;
    try {
        // The old one first: two scenes may be more than the GPU's memory holds.
        stage_.reset();
        stage_ = std::make_unique<StageView>(std::move(*result.scene), result.path,
                                             options_.cache ? &*options_.cache : nullptr);
    } catch (const std::exception& error) {
        state_.sayError(oneLine(error.what()));
        return;
    }
    if (!isSame) {
        const bool isFirst = stats_.scenesLoaded == 1;
        const double aspectRatio =
            double(std::max(1, window_.pixels().x)) / double(std::max(1, window_.pixels().y));
        const Scene& scene = stage_->scene();
        const Camera camera = isFirst && options_.look.camera ? *options_.look.camera
                              : scene.cameras.empty()
                                  ? makeFramingCamera(stage_->bounds(), aspectRatio)
                                  : scene.cameras.front();
        state_.view = viewpointOf(stage_->posed(camera), stage_->bounds());
        state_.selected = -1;
        state_.lookFile =
            isFirst && !options_.lookFile.empty() ? options_.lookFile : lookBeside(result.path);
        if (!isFirst) {
            state_.look = Look{};
        }
        state_.look.scene = result.path.filename().string();
        if (state_.lookFile != options_.lookFile && std::filesystem::exists(state_.lookFile)) {
            state_.say("a look lies beside the scene: Ctrl+O loads " +
                       state_.lookFile.filename().string());
        }
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
    ++lampsNow_;
    bringLook();
}

// Brings the look's lamps to the scene, and takes back what cannot be brought.
void Viewer::bringLook() {
    try {
        stage_->bring(state_.look);
    } catch (const Error& error) {
        state_.sayError(error.what());
        for (LampChange& change : state_.look.lamps) {
            if (change.lightMap.file && change.lightMap.file->string() == error.place().file) {
                change.lightMap.file.reset();
            }
        }
        stage_->bring(state_.look);
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

void Viewer::takeLoaded() {
    if (std::optional<BackgroundLoader::Result> result = loader_.take()) {
        show(std::move(*result));
    }
}

void Viewer::takeChanged() {
    for (const std::filesystem::path& file : watch_.takeChanged()) {
        if (!stage_ || !std::filesystem::exists(file)) {
            if (stage_) {
                state_.sayError(file.string() + ": is gone (the picture stays as it was)");
            }
            continue;
        }
        const bool isLightMap = std::any_of(
            state_.look.lamps.begin(), state_.look.lamps.end(), [&](const LampChange& change) {
                return change.lightMap.file && *change.lightMap.file == file;
            });
        if (isLightMap) {
            stage_->forgetLightMap(file);
            bringLook();
            state_.say("reloaded " + file.filename().string());
        } else if (file.lexically_normal() ==
                   std::filesystem::absolute(state_.lookFile).lexically_normal()) {
            reloadLook();
        } else {
            loader_.load(stage_->path());
        }
    }
}

void Viewer::drop(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    if (ending == ".gltf" || ending == ".glb") {
        loader_.load(file);
    } else if (ending == ".json") {
        state_.lookFile = file;
        loadLook();
    } else if (!stage_) {
        state_.sayError(file.string() + ": is no scene; drop a .gltf or .glb file");
    } else if (state_.selected < 0) {
        state_.sayError(file.string() + ": choose a lamp first, to give it this light map");
    } else {
        const LampId& lamp = stage_->lamps()[std::size_t(state_.selected)];
        if (lamp.kind == LampId::Kind::kSpot) {
            state_.changeOf(lamp.name, lamp.number).lightMap.file =
                std::filesystem::absolute(file).lexically_normal();
        } else {
            state_.sayError("lamp '" + lamp.name + "' is no spot and takes no light map");
        }
    }
}

void Viewer::takeDropped() {
    for (const std::filesystem::path& file : window_.takeDropped()) {
        drop(file);
    }
}

void Viewer::saveLook() {
    Look look = state_.look;
    state_.isPlaying = false;
    std::erase_if(look.lamps, [](const LampChange& change) { return change.isIdle(); });
    look.camera = state_.view.camera;
    look.size = window_.pixels();
    try {
        writeLook(look, state_.lookFile);
        // What the file says, to the last digit, is what is shown from now on.
        savedLook_ = readLook(state_.lookFile);
        state_.look = savedLook_;
        const int node = state_.view.camera.node;
        state_.view.camera = *savedLook_.camera;
        state_.view.camera.node = node;
        state_.say("saved " + state_.lookFile.string());
    } catch (const Error& error) {
        state_.sayError(error.what());
    }
}

void Viewer::loadLook() {
    try {
        Look look = readLook(state_.lookFile);
        const std::vector<std::string> missing = lampsNotThere(look.lamps, stage_->scene());
        for (const std::string& lamp : missing) {
            state_.sayError("look: the scene has no lamp '" + lamp + "'");
        }
        if (look.camera) {
            state_.view = viewpointOf(*look.camera, stage_->bounds());
        }
        state_.look = std::move(look);
        state_.say("loaded " + state_.lookFile.string());
    } catch (const Error& error) {
        state_.sayError(std::string(error.what()) + " (the look stays as it was)");
    }
}

// What the window itself wrote is what it shows.
void Viewer::reloadLook() {
    try {
        if (readLook(state_.lookFile) == savedLook_) {
            return;
        }
    } catch (const Error&) {
        // Told by loadLook().
    }
    loadLook();
}

void Viewer::savePicture() {
    const glm::ivec2 size = window_.pixels();
    if (size.x == 0 || size.y == 0) {
        state_.sayError("the window has no pixels to save");
        return;
    }
    drawStill(stillSettings());
    const std::filesystem::path file =
        freePicture(options_.pictures, stage_->path().stem().string());
    try {
        writePng(file, size.x, size.y, readDisplay(stage_->renderer().targets()));
        state_.say("saved " + file.string());
    } catch (const Error& error) {
        state_.sayError(error.what());
    }
}

void Viewer::carryOut(ViewerRequests requests) {
    state_.requests = {};
    if (requests.quit) {
        window_.close();
    }
    if (!stage_) {
        return;
    }
    if (requests.reload) {
        loader_.load(stage_->path());
    }
    if (requests.saveLook) {
        saveLook();
        watchFiles();
    }
    if (requests.loadLook) {
        loadLook();
    }
    if (requests.savePicture) {
        savePicture();
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
    const glm::ivec2 pixel(int(share.x * facts_.size.x),
                           facts_.size.y - 1 - int(share.y * facts_.size.y));
    char text[96];
    std::snprintf(text, sizeof text, state_.highestLux ? "%.4g lx" : "%.4g cd/m2",
                  luminance(stage_->lightAt(pixel)));
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
    facts_.isStill = true;
    facts_.framesPerSecond = 0.0;
    facts_.size = {still.width, still.height};
    facts_.sheets = still.beams.planes;
    facts_.ev100 = stage_->renderer().ev100();
}

void Viewer::drawPicture() {
    const FrameSettings still = stillSettings();
    const bool moves = seenFrom_ != state_.view || seenAs_ != still || lampsSeen_ != lampsNow_;
    // The first picture is drawn as it is to be; after that, what changes is shown at once.
    const bool isFirst = !seenFrom_.has_value();
    if (moves) {
        movedAt_ = Clock::now();
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
    if (!moves) {
        return;
    }
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
        drawLegend(state_);
        drawPanels(state_, *stage_, facts_);
    }
    handleKeys(keys, state_, stage_.get(), window_.pixels());
    drawHelp(state_);
    drawMessages(state_, busy());
}

// Nothing needs drawing: until something comes. Otherwise until the picture is to be refined.
double Viewer::secondsToWait() const {
    if (unsettled_ > 0 || pointer_.isWalking() || state_.isPlaying) {
        return 0.0;
    }
    double seconds = std::numeric_limits<double>::infinity();
    if (stage_ && !facts_.isStill) {
        seconds = std::max(1e-3, kRestSeconds - secondsSince(movedAt_));
    }
    for (const ViewerMessage& message : state_.messages) {
        const std::chrono::duration<double> left = message.until - Clock::now();
        seconds = std::min(seconds, std::max(1e-3, left.count()));
    }
    return loader_.reading() ? std::min(seconds, 0.25) : seconds;
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
        const glm::ivec2 size = window_.pixels();
        playOn();
        if (stage_ && size.x > 0 && size.y > 0) {
            if (state_.look != broughtLook_) {
                bringLook();
            }
            drawPicture();
        }
        const bool hasPicture = stage_ && stage_->hasPicture();
        window_.showFrame(hasPicture ? stage_->renderer().targets().screen.name() : 0, facts_.size);
        ++stats_.framesShown;
        stats_.glErrors += takeGlErrors().size();
    }
    return stats_;
}

}  // namespace

ViewerStats runViewer(ViewerOptions options) {
    Viewer viewer(std::move(options));
    return viewer.run();
}

}  // namespace ribalta
