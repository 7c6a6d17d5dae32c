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

// Called with the terminal's mutex held.
void Progress::show() const {
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - start_);
    std::fprintf(stderr, "\r\x1b[K%s", what_.c_str());
    if (total_ > 1) {
        std::fprintf(stderr, "  %zu/%zu", done_.load(), total_);
    }
    std::fprintf(stderr, "  %lld s", static_cast<long long>(seconds.count()));
    std::fflush(stderr);
    terminal().lineShown = true;
}

void Progress::writeLine(const std::string& line) {
    const std::scoped_lock lock(terminal().mutex);
    terminal().clear();
    std::fprintf(stderr, "%s\n", line.c_str());
}

}  // namespace ribalta
