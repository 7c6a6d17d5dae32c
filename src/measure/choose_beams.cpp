#include "measure/choose_beams.h"

#include <algorithm>
#include <array>
#include <functional>

#include "measure/display_picture.h"
#include "measure/measure_point.h"
#include "measure/picture_error.h"
#include "measure/statistics.h"

namespace ribalta {
namespace {

constexpr std::array kLadder = {4,  5,  6,  8,  10, 12, 14, 16,  20, 24,
                                28, 32, 40, 48, 64, 80, 96, 128, 192};
constexpr std::array kMethods = {BeamMethod::kAdaptive, BeamMethod::kClipped};
// Errors fall a little faster than the number of sheets grows.
constexpr int kManySheets = 512;
constexpr int kTimedFrames = 3;

using Rung = std::size_t;  // into kLadder

// A view in which settings can be tried out.
class Trial {
  public:
    Trial(Renderer& renderer, const Camera& camera, const FrameSettings& settings,
          const std::function<void()>& betweenFrames)
        : renderer_(renderer),
          camera_(camera),
          settings_(settings),
          half_(settings),
          betweenFrames_(betweenFrames) {
        half_.width = std::max(1, settings.width / 2);
        half_.height = std::max(1, settings.height / 2);
        half_.beams = with(BeamMethod::kClipped, kManySheets);
        betweenFrames_();
        answer_ = drawLight(renderer_, camera_, half_).total;
        ev100_ = settings.ev100.value_or(autoExposure(answer_));
        answer_ = displayPicture(answer_, ev100_, settings.toneCurve);
        half_.ev100 = ev100_;
    }

    double errorPercent(const BeamSettings& beams) {
        half_.beams = beams;
        betweenFrames_();
        const RgbPicture picture = drawLight(renderer_, camera_, half_).total;
        return displayRmsePercent(displayPicture(picture, ev100_, settings_.toneCurve), answer_);
    }

    double beamsMs(const BeamSettings& beams) {
        settings_.beams = beams;
        std::vector<double> times;
        for (int i = 0; i <= kTimedFrames; ++i) {
            betweenFrames_();
            renderer_.redrawNextFrame();
            renderer_.draw(camera_, settings_);
            double ms = 0.0;
            for (const PassTime& pass : renderer_.takeTimes()) {
                ms += pass.name == "beams" ? pass.gpuMs : 0.0;
            }
            if (i > 0) {  // the first builds programs
                times.push_back(ms);
            }
        }
        return median(times);
    }

    BeamSettings with(BeamMethod method, int planes) const {
        BeamSettings beams = settings_.beams;
        beams.method = method;
        beams.planes = planes;
        return beams;
    }

  private:
    Renderer& renderer_;
    const Camera& camera_;
    FrameSettings settings_;
    FrameSettings half_;
    const std::function<void()>& betweenFrames_;
    RgbPicture answer_;
    double ev100_ = 0.0;
};

// What was measured of the rungs that were tried.
using Tried = std::array<std::optional<double>, kLadder.size()>;

// The first rung from which what is measured passes; kLadder.size() if none. The rung before it, if
// there is one, has then been measured too.
Rung firstRung(const std::function<double(int planes)>& measure,
               const std::function<bool(double measured)>& passes, Tried& tried) {
    Rung low = 0;
    Rung high = kLadder.size();
    while (low < high) {
        const Rung middle = (low + high) / 2;
        tried.at(middle) = measure(kLadder.at(middle));
        if (passes(*tried.at(middle))) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return low;
}

// The fewest sheets within the error, or the most there are.
BeamChoice reachError(Trial& trial, BeamMethod method, double errorPercent) {
    Tried errors;
    const Rung rung =
        firstRung([&](int planes) { return trial.errorPercent(trial.with(method, planes)); },
                  [&](double error) { return error <= errorPercent; }, errors);
    const Rung taken = std::min(rung, kLadder.size() - 1);
    BeamChoice choice;
    choice.beams = trial.with(method, kLadder.at(taken));
    choice.errorPercent = errors.at(taken).value();
    choice.beamsMs = trial.beamsMs(choice.beams);
    choice.reached = rung < kLadder.size();
    return choice;
}

// The most sheets within the time, or the fewest there are.
BeamChoice reachBudget(Trial& trial, BeamMethod method, double budgetMs) {
    Tried times;
    const Rung rung =
        firstRung([&](int planes) { return trial.beamsMs(trial.with(method, planes)); },
                  [&](double ms) { return ms > budgetMs; }, times);
    const Rung taken = std::max<Rung>(rung, 1) - 1;
    BeamChoice choice;
    choice.beams = trial.with(method, kLadder.at(taken));
    choice.errorPercent = trial.errorPercent(choice.beams);
    choice.beamsMs = times.at(taken).value();
    choice.reached = rung > 0;
    return choice;
}

}  // namespace

BeamChoice chooseBeams(Renderer& renderer, const Camera& camera, const FrameSettings& settings,
                       const BeamGoal& goal, const std::function<void()>& betweenFrames) {
    Trial trial(renderer, camera, settings, betweenFrames);
    std::optional<BeamChoice> best;
    for (const BeamMethod method : kMethods) {
        const BeamChoice choice = goal.budgetMs ? reachBudget(trial, method, *goal.budgetMs)
                                                : reachError(trial, method, goal.errorPercent);
        // Out of reach, the nearest: fastest for a time, closest for an error.
        const bool byTime = goal.budgetMs.has_value() != choice.reached;
        const bool better =
            !best || (choice.reached && !best->reached) ||
            (choice.reached == best->reached &&
             (byTime ? choice.beamsMs < best->beamsMs : choice.errorPercent < best->errorPercent));
        if (better) {
            best = choice;
        }
    }
    return *best;
}

}  // namespace ribalta
