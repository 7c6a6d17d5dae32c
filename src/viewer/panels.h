// The panels at the window's right, the marks over the picture, the help: what a person sees and
// touches besides the picture itself.
#pragma once

#include <string>
#include <vector>

#include "gl/timer.h"
#include "viewer/stage_view.h"
#include "viewer/viewer_state.h"

namespace ribalta {

/// What is told of the picture that is there.
struct PictureFacts {
    std::string renderer;
    double framesPerSecond = 0.0;  ///< while things move; 0: nothing does
    glm::ivec2 size{0};            ///< pixels that were drawn
    int sheets = 0;                ///< a beam
    bool isStill = false;          ///< of the look's own quality
    std::vector<PassTime> passes;
    std::optional<double> ev100;
    std::string probe;  ///< what lies under the pointer
    std::string error;  ///< how far its beams are from the reference; empty: nobody has asked
};

/// Panels for the scene, its lamps and how it is seen. Changes `state` alone.
void drawPanels(ViewerState& state, const StageView& stage, const PictureFacts& facts);

/// The editor of the lamp that is selected.
void drawLampPanel(ViewerState& state, const StageView& stage);
void drawLampList(ViewerState& state, const StageView& stage);

/// Play, time, speed, loop, and which animation.
void drawAnimationPanel(ViewerState& state, const StageView& stage);

/// Haze, quality, exposure and sky.
void drawLightPanels(ViewerState& state, const PictureFacts& facts);

/// What the false colours mean, where they are shown.
void drawLegend(const ViewerState& state);

/// Keys and what they do.
void drawHelp(ViewerState& state);

/// Lines at the lower left, those whose time is over taken away; `busy` is shown first.
void drawMessages(ViewerState& state, const std::string& busy);

}  // namespace ribalta
