#include "viewer/watch_files.h"

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <utility>

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <unistd.h>

#include "base/log.h"
#include "viewer/paths.h"
#include "viewer/window.h"

namespace ribalta {
namespace {

constexpr std::uint32_t kChanges = IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE;

}  // namespace

FileWatch::FileWatch()
    : queue_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)), stop_(eventfd(0, EFD_CLOEXEC)) {
    if (queue_ < 0 || stop_ < 0) {
        logWarning(std::string("files are not watched for changes: ") + std::strerror(errno));
        return;
    }
    listener_ = std::jthread([this] { listen(); });
}

FileWatch::~FileWatch() {
    if (listener_.joinable()) {
        const std::uint64_t one = 1;
        while (write(stop_, &one, sizeof one) < 0 && errno == EINTR) {
        }
        listener_.join();
    }
    for (const int file : {queue_, stop_}) {
        if (file >= 0) {
            close(file);
        }
    }
}

void FileWatch::watch(const std::vector<std::filesystem::path>& files) {
    if (queue_ < 0) {
        return;
    }
    const std::scoped_lock lock(mutex_);
    files_.clear();
    std::set<std::filesystem::path> folders;
    for (const std::filesystem::path& file : files) {
        const std::filesystem::path path = plainPath(file);
        files_.insert(path);
        folders.insert(path.parent_path());
    }
    // Watches that are still needed stay: what they have to tell would be lost with them.
    std::erase_if(folders_, [&](const auto& watched) {
        if (folders.erase(watched.second) > 0) {
            return false;
        }
        inotify_rm_watch(queue_, watched.first);
        return true;
    });
    for (const std::filesystem::path& folder : folders) {
        // Folders and not files: what is saved under another name and renamed is a new file.
        const int descriptor = inotify_add_watch(queue_, folder.c_str(), kChanges);
        if (descriptor < 0) {
            logWarning(folder.string() + ": is not watched for changes: " + std::strerror(errno));
        } else {
            folders_[descriptor] = folder;
        }
    }
}

std::set<std::filesystem::path> FileWatch::takeChanged() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(changed_, {});
}

void FileWatch::listen() {
    alignas(inotify_event) std::array<char, 1 << 14> bytes{};
    std::array<pollfd, 2> sources = {{{queue_, POLLIN, 0}, {stop_, POLLIN, 0}}};
    while (true) {
        if (poll(sources.data(), sources.size(), -1) < 0) {
            if (errno == EINTR) {
                continue;
            }
            return;
        }
        if (sources[1].revents != 0) {
            return;
        }
        const ssize_t size = read(queue_, bytes.data(), bytes.size());
        bool any = false;
        const std::scoped_lock lock(mutex_);
        for (ssize_t at = 0; at < size;) {
            const auto* event = reinterpret_cast<const inotify_event*>(bytes.data() + at);
            at += ssize_t(sizeof(inotify_event) + event->len);
            const auto folder = folders_.find(event->wd);
            if (folder == folders_.end() || event->len == 0) {
                continue;
            }
            const std::filesystem::path file = folder->second / event->name;
            if (files_.contains(file)) {
                changed_.insert(file);
                any = true;
            }
        }
        if (any) {
            Window::wake();
        }
    }
}

}  // namespace ribalta
