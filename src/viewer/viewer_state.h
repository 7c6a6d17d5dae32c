// ViewerState: what the window shows and what is being done in it, as plain data. Panels and keys
// change it, the viewer carries it out.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "look/apply_look.h"
#include "look/look.h"
#include "measure/choose_beams.h"
#include "measure/error_estimate.h"
#include "viewer/navigate.h"

namespace ribalta {

/// A line that the window shows for a while.
struct ViewerMessage {
    std::string text;
    bool isError = false;
    std::chrono::steady_clock::time_point until;
};

/// What a person has asked for and the viewer has still to do.
struct ViewerRequests {
    bool savePicture = false;
    bool saveLook = false;
    bool loadLook = false;
    bool reload = false;
    bool quit = false;
    std::optional<ErrorEstimate::Against> measureError;
    std::optional<BeamGoal> chooseBeams;
};

struct ViewerState {
    Look look;  ///< but for its camera, which is that of `view` when it is saved
    Viewpoint view;
    int selected = -1;  ///< into StageView::lamps()
    bool isPlaying = false;
    bool loops = true;
    double speed = 1.0;
    std::optional<double> highestLux;  ///< shows illuminance in false colours up to this
    bool showPanels = true;
    bool showHelp = false;
    bool showStatistics = true;
    bool showLamps = true;
    std::string lampFilter;
    BeamGoal goal{16.0, 0.5};  ///< of the fields for one; each is asked for by itself
    std::string lightMapText;  ///< of the light map's field, until Enter
    std::filesystem::path lookFile;
    std::vector<ViewerMessage> messages;
    ViewerRequests requests;

    /// Lets `elapsed` seconds of the animation pass, where it is being played; `duration` seconds
    /// long, it starts anew or stops at its end.
    void play(double elapsed, double duration);

    /// Shows a line for some seconds, errors for longer, and writes it to the log.
    void say(const std::string& text);
    void sayError(const std::string& text);

    /// The look's change of a lamp; made where there is none.
    LampChange& changeOf(const LampId& lamp) { return findOrAddChange(look.lamps, lamp); }
};

}  // namespace ribalta
