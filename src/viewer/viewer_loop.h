// Viewer: what the window is at, from one frame to the next. Internal to this module.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/background_loader.h"
#include "viewer/live_quality.h"
#include "viewer/panels.h"
#include "viewer/pointer.h"
#include "viewer/stage_view.h"
#include "viewer/viewer.h"
#include "viewer/watch_files.h"
#include "viewer/window.h"

namespace ribalta {

/// Frames of panels after the last event, until they have settled.
inline constexpr int kSettlingFrames = 3;

class Viewer {
  public:
    explicit Viewer(ViewerOptions options);

    /// Until the window is closed.
    ViewerStats run();

  private:
    using Clock = std::chrono::steady_clock;

    // Scenes as files (viewer_scene.cpp).
    void open(const std::filesystem::path& scene);
    void takeLoaded();
    void takeChanged();
    void takeDropped();
    void drop(const std::filesystem::path& file);
    void show(BackgroundLoader::SceneRead read);
    void tellOfEnd(const BackgroundLoader::End& end);
    void beginScene(bool isFirst);
    void continueScene(const std::optional<LampId>& selected);
    void renewShaders();
    void watchFiles();

    // The look and pictures as files (viewer_look.cpp).
    void bringLook();
    void carryOut(ViewerRequests requests);
    void saveLook();
    void loadLook(const std::filesystem::path& file, bool evenIfKept);
    void takeLook(Look look, const std::filesystem::path& file);
    void keepUnsavedLook();
    void savePicture();

    // Measurements (viewer_measure.cpp).
    void measure(const ViewerRequests& requests);
    void measureError(ErrorEstimate::Against against);
    void chooseBeams(const BeamGoal& goal);
    std::string errorSoFar() const;

    // Frames (viewer.cpp).
    void drawInterface();
    void drawPicture();
    void drawStill(const FrameSettings& still);
    void drawMoving(const FrameSettings& still);
    void playOn();
    double patienceSeconds() const;
    double secondsToWait() const;
    std::string busy() const;
    std::string probe() const;
    FrameSettings stillSettings() const;
    bool hasPixels() const { return window_.pixels().x > 0 && window_.pixels().y > 0; }

    ViewerOptions options_;
    Window window_;
    FileWatch watch_;
    BackgroundLoader loader_;
    std::filesystem::path scenePath_;  ///< that was last asked for, absolute
    std::unique_ptr<StageView> stage_;
    ViewerState state_;
    std::vector<std::filesystem::path> watched_;  ///< of the scene and its light maps
    std::vector<std::filesystem::path> shaders_;  ///< files that programs are made of
    bool isComplete_ = false;                     ///< the scene has all its pictures
    Clock::time_point shownSince_;                ///< the scene
    Clock::time_point lastFrame_ = Clock::now();
    bool played_ = false;        ///< in the frame before
    Look broughtLook_;           ///< what the scene's lamps are as
    Look keptLook_;              ///< as its file has it; what differs from it would be lost
    bool ownsLookFile_ = false;  ///< it was read or written here, and may be written again
    Pointer pointer_;
    LiveQuality quality_;
    std::unique_ptr<ErrorEstimate> error_;  ///< of the picture that is there; none: not asked for
    PictureFacts facts_;
    ViewerStats stats_;

    // What the last picture was asked for with, and since when that has been so.
    std::optional<Viewpoint> seenFrom_;
    std::optional<FrameSettings> seenAs_;
    std::uint64_t lampsSeen_ = 0;
    std::uint64_t lampsNow_ = 0;
    Clock::time_point movedAt_;
    Clock::time_point lastMove_;
    bool failed_ = false;  ///< what was asked for cannot be drawn
    int unsettled_ = kSettlingFrames;
};

}  // namespace ribalta
