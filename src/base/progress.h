// A progress line on stderr, only on a terminal and only for work that lasts over a second.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <string>
#include <thread>

namespace ribalta {

/// Shows "what  37/128  4 s" in place while it lives, from the first second on, and how much time
/// is left where that was told. Where several live, the newest is shown. step() and expectLeft()
/// may be called from any thread.
class Progress {
  public:
    /// `total` steps of work; zero where there are none to count.
    explicit Progress(std::string what, std::size_t total = 0);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void step() { ++done_; }
    /// How long the rest will probably take from now on; counted down until it is said anew.
    void expectLeft(double seconds);

    /// Writes a line to stderr, in the place of a progress line where one is on the terminal.
    static void writeLine(const std::string& line);

  private:
    void show() const;

    std::string what_;
    std::size_t total_;
    std::atomic<std::size_t> done_ = 0;
    std::atomic<double> endSeconds_ = -1.0;  ///< expected, since the start; below 0: not known
    std::chrono::steady_clock::time_point start_;
    std::jthread ticker_;  ///< only on a terminal: work that takes long need not call step()
};

}  // namespace ribalta
