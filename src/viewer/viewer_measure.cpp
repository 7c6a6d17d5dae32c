// Viewer's measurements: the error of the picture at hand, and beams for a time or an error.
#include <cstdio>
#include <utility>

#include "base/error.h"
#include "viewer/viewer_loop.h"

namespace ribalta {
namespace {

// The window was closed meanwhile.
struct Closing {};

}  // namespace

void Viewer::measure(const ViewerRequests& requests) {
    state_.requests.measureError.reset();
    state_.requests.chooseBeams.reset();
    if (stage_ && requests.measureError) {
        measureError(*requests.measureError);
    }
    if (stage_ && requests.chooseBeams) {
        chooseBeams(*requests.chooseBeams);
    }
}

void Viewer::measureError(ErrorEstimate::Against against) {
    error_.reset();
    const FrameSettings still = stillSettings();
    if (still.sky || still.illuminance || !(still.haze.scatteringPerMetre > 0.0) || !hasPixels()) {
        state_.sayError(
            "the beams' error needs a picture with haze, without a sky and without false "
            "colours");
        return;
    }
    try {
        drawStill(still);
        const double ev100 = facts_.ev100.value_or(0.0);
        error_ = std::make_unique<ErrorEstimate>(stage_->lendRenderer(), stage_->scene(),
                                                 state_.view.camera, still, ev100, against);
        stage_->takeTimes();  // of frames that are not shown
        drawStill(still);
    } catch (const std::exception& error) {
        state_.sayError(oneLine(error.what()));
    }
}

std::string Viewer::errorSoFar() const {
    if (!error_) {
        return {};
    }
    const ErrorEstimate::Value value = error_->value();
    if (!value.failure.empty()) {
        return value.failure;
    }
    if (value.pixels == 0) {
        return "measuring";
    }
    char text[96];
    std::snprintf(text, sizeof text, "%.3g +- %.1g %% (%zu pixels%s)", value.rmsePercent,
                  value.uncertainty, value.pixels, value.isDone ? "" : ", going on");
    return text;
}

void Viewer::chooseBeams(const BeamGoal& goal) {
    error_.reset();
    const FrameSettings still = stillSettings();
    if (still.illuminance || !hasPixels()) {
        state_.sayError("beams are chosen by a picture of them: switch the false colours off");
        return;
    }
    int tried = 0;
    const auto betweenFrames = [&] {
        window_.takeEvents(0.0);
        if (window_.isClosing()) {
            throw Closing{};
        }
        window_.beginFrame();
        drawMessages(state_,
                     "trying methods and numbers of sheets, frame " + std::to_string(++tried));
        window_.showFrame(0, {});
    };
    try {
        const BeamChoice choice = ribalta::chooseBeams(stage_->lendRenderer(), state_.view.camera,
                                                       still, goal, betweenFrames);
        state_.look.beams = choice.beams;
        char text[160];
        std::snprintf(text, sizeof text, "%s with %d sheets: %.2f ms, %.2f %%%s",
                      std::string(name(choice.beams.method)).c_str(), choice.beams.planes,
                      choice.beamsMs, choice.errorPercent,
                      choice.reached ? "" : "; the goal is out of reach");
        state_.say(text);
        drawStill(stillSettings());
    } catch (const Closing&) {
    } catch (const std::exception& error) {
        state_.sayError(oneLine(error.what()));
    }
}

}  // namespace ribalta
