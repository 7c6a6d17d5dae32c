// InterruptWatch: work that is to be ended in order when the user has had enough.
#pragma once

#include <array>
#include <csignal>

namespace ribalta {

/// While one lives, the first SIGINT, SIGTERM or SIGHUP is only noted; a second one ends the
/// process as it would have without the watch. One at a time.
class InterruptWatch {
  public:
    InterruptWatch();
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;

    /// The signal that came, or 0.
    static int noted();

  private:
    static constexpr std::array<int, 3> kSignals = {SIGINT, SIGTERM, SIGHUP};
    std::array<struct sigaction, kSignals.size()> before_{};
};

}  // namespace ribalta
