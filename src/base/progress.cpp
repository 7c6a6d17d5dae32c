#include "base/progress.h"

#include <cstdio>
#include <utility>

#include <unistd.h>

namespace ribalta {
namespace {

using Clock = std::chrono::steady_clock;

std::atomic<bool> lineShown = false;

bool onTerminal() {
    static const bool terminal = isatty(STDERR_FILENO) != 0;
    return terminal;
}

}  // namespace

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)), total_(total), start_(Clock::now()), shown_(start_) {}

Progress::~Progress() {
    clearLine();
}

void Progress::step() {
    const std::size_t done = ++done_;
    if (!onTerminal()) {
        return;
    }
    const std::scoped_lock lock(mutex_);
    const auto now = Clock::now();
    if (now - start_ < std::chrono::seconds(1) || now - shown_ < std::chrono::milliseconds(100)) {
        return;
    }
    shown_ = now;
    if (total_ == 0) {
        std::fprintf(stderr, "\r\x1b[K%s  %zu", what_.c_str(), done);
    } else {
        std::fprintf(stderr, "\r\x1b[K%s  %zu/%zu", what_.c_str(), done, total_);
    }
    std::fflush(stderr);
    lineShown = true;
}

void Progress::clearLine() {
    if (lineShown.exchange(false)) {
        std::fputs("\r\x1b[K", stderr);
        std::fflush(stderr);
    }
}

}  // namespace ribalta
