#include "viewer/viewer_state.h"

#include <cmath>

#include "base/log.h"

namespace ribalta {
namespace {

using std::chrono::seconds;
using std::chrono::steady_clock;

constexpr seconds kShown(5);
constexpr seconds kErrorShown(15);

}  // namespace

void ViewerState::play(double elapsed, double duration) {
    if (!isPlaying || !(duration > 0.0)) {
        isPlaying = false;
        return;
    }
    if (!look.time) {
        look.time.emplace();
    }
    double& seconds = look.time->seconds;
    seconds += elapsed * speed;
    if (seconds > duration && loops) {
        seconds = std::fmod(seconds, duration);
    } else if (seconds > duration) {
        seconds = duration;
        isPlaying = false;
    }
}

void ViewerState::say(const std::string& text) {
    logNote(text);
    messages.push_back({text, false, steady_clock::now() + kShown});
}

void ViewerState::sayError(const std::string& text) {
    logWarning(text);
    messages.push_back({text, true, steady_clock::now() + kErrorShown});
}

}  // namespace ribalta
