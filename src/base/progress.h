// A progress line on stderr, only on a terminal and only for work that lasts over a second.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

namespace ribalta {

/// Shows "what  37/128" in place while it lives; step() may be called from any thread.
class Progress {
  public:
    /// `total` steps of work; zero where the number is not known.
    Progress(std::string what, std::size_t total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void step();

    /// Removes a progress line that is on the terminal, so that another line can be written.
    static void clearLine();

  private:
    std::string what_;
    std::size_t total_;
    std::atomic<std::size_t> done_ = 0;
    std::mutex mutex_;
    std::chrono::steady_clock::time_point start_;
    std::chrono::steady_clock::time_point shown_;
};

}  // namespace ribalta
