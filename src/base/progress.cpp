#include "base/progress.h"

#include <algorithm>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <utility>
#include <vector>

#include <unistd.h>

namespace ribalta {
namespace {

using Clock = std::chrono::steady_clock;

// One terminal, so one of these: who may write to it, and what stands there.
struct Terminal {
    std::mutex mutex;
    std::condition_variable_any ended;
    std::vector<const Progress*> living;
    bool lineShown = false;

    void clear() {
        if (std::exchange(lineShown, false)) {
            std::fputs("\r\x1b[K", stderr);
        }
    }
};

Terminal& terminal() {
    static Terminal instance;
    return instance;
}

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

bool onTerminal() {
    static const bool yes = isatty(STDERR_FILENO) != 0;
    return yes;
}

}  // namespace

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)), total_(total), start_(Clock::now()) {
    if (!onTerminal()) {
        return;
    }
    const std::scoped_lock lock(terminal().mutex);
    terminal().living.push_back(this);
    ticker_ = std::jthread([this](const std::stop_token& stop) {
        std::unique_lock held(terminal().mutex);
        auto next = start_ + std::chrono::seconds(1);
        while (
            !terminal().ended.wait_until(held, stop, next, [&] { return stop.stop_requested(); })) {
            if (terminal().living.back() == this) {
                show();
            }
            next += std::chrono::milliseconds(200);
        }
    });
}

Progress::~Progress() {
    if (!ticker_.joinable()) {
        return;
    }
    ticker_.request_stop();
    ticker_.join();
    Terminal& shared = terminal();
    const std::scoped_lock lock(shared.mutex);
    shared.living.erase(std::find(shared.living.begin(), shared.living.end(), this));
    shared.clear();
    std::fflush(stderr);
}

void Progress::expectLeft(double seconds) {
    endSeconds_ = secondsSince(start_) + seconds;
}

// Called with the terminal's mutex held.
void Progress::show() const {
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - start_);
    std::fprintf(stderr, "\r\x1b[K%s", what_.c_str());
    if (total_ > 1) {
        std::fprintf(stderr, "  %zu/%zu", done_.load(), total_);
    }
    std::fprintf(stderr, "  %lld s", static_cast<long long>(seconds.count()));
    if (endSeconds_ >= 0.0) {
        const double left = std::max(0.0, endSeconds_ - secondsSince(start_));
        std::fprintf(stderr, left < 100.0 ? ", about %.0f s left" : ", about %.0f min left",
                     left < 100.0 ? left : left / 60.0);
    }
    std::fflush(stderr);
    terminal().lineShown = true;
}

void Progress::writeLine(const std::string& line) {
    const std::scoped_lock lock(terminal().mutex);
    terminal().clear();
    std::fprintf(stderr, "%s\n", line.c_str());
}

}  // namespace ribalta
