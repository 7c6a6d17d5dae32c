// FileWatch: tells when files change, without looking at them again and again (Linux's inotify).
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

namespace ribalta {

class FileWatch {
  public:
    /// Watches nothing yet. Where the system offers no watches, a warning says so and nothing is
    /// ever told.
    FileWatch();
    ~FileWatch();
    FileWatch(const FileWatch&) = delete;
    FileWatch& operator=(const FileWatch&) = delete;

    /// From now on these files and no others. A file need not be there; its folder must.
    void watch(const std::vector<std::filesystem::path>& files);
    /// Those written, replaced or removed since the last call, once a writer has let go of them.
    /// Window::wake() tells when to ask.
    std::set<std::filesystem::path> takeChanged();

  private:
    void listen();

    int queue_ = -1;  ///< inotify's
    int stop_ = -1;   ///< an eventfd that ends listen()
    std::mutex mutex_;
    std::map<int, std::filesystem::path> folders_;  ///< by watch; guarded by mutex_
    std::set<std::filesystem::path> files_;         ///< absolute; guarded by mutex_
    std::set<std::filesystem::path> changed_;       ///< guarded by mutex_
    std::jthread listener_;                         ///< last: uses the above
};

}  // namespace ribalta
