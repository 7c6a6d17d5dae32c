#include "base/read_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <exception>
#include <string>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"

namespace ribalta {
namespace {

class OpenFile {
  public:
    explicit OpenFile(const Place& place, const std::filesystem::path& path)
        : place_(place),
          // Without O_NONBLOCK a pipe would be waited for; a terminal is not to become this
          // program's own.
          descriptor_(path.empty()
                          ? -1
                          : open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {
        const int reason = path.empty() ? ENOENT : errno;
        if (descriptor_ >= 0) {
            return;
        }
        if (reason == ENOENT || reason == ENOTDIR) {
            refuse("no such file; check the path");
        }
        // A socket, or a device that nothing answers for.
        if (reason == ENXIO || reason == ENODEV) {
            refuse("is not a regular file; give a file");
        }
        refuse(std::string("cannot be opened: ") + std::strerror(reason));
    }
    ~OpenFile() {
        if (descriptor_ >= 0) {
            close(descriptor_);
        }
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    [[noreturn]] void refuse(const std::string& message) const {
        throw Error(ErrorKind::kBadInput, place_, message);
    }

    [[noreturn]] void refuseUnread(int reason) const {
        refuse(std::string("cannot be read: ") + std::strerror(reason) +
               "; check its permissions and its disk");
    }

    std::uint64_t size() const {
        struct stat status {};
        if (fstat(descriptor_, &status) != 0) {
            refuse(std::string("cannot be opened: ") + std::strerror(errno));
        }
        if (!S_ISREG(status.st_mode)) {
            refuse("is not a regular file; give a file");
        }
        return std::uint64_t(status.st_size);
    }

    // A file that has become shorter since is one that cannot be read.
    void fill(std::vector<std::byte>& bytes) const {
        constexpr std::size_t kMostAtOnce = std::size_t(1) << 30U;
        for (std::size_t at = 0; at < bytes.size();) {
            const ssize_t count =
                read(descriptor_, &bytes[at], std::min(bytes.size() - at, kMostAtOnce));
            if (count == 0) {
                refuse("became shorter while it was read; try again when it is written");
            }
            if (count < 0 && errno != EINTR) {
                refuseUnread(errno);
            }
            at += count > 0 ? std::size_t(count) : 0;
        }
    }

  private:
    const Place& place_;
    int descriptor_;
};

}  // namespace

std::vector<std::byte> readFile(const std::filesystem::path& path, std::uint64_t limitBytes,
                                std::uint64_t wantedBytes) {
    const Place place{path.empty() ? "''" : path.string(), ""};
    const OpenFile file(place, path);
    const std::uint64_t size = std::min(file.size(), wantedBytes);
    if (size > limitBytes) {
        file.refuse("has " + std::to_string(size) + " bytes, over the limit of " +
                    std::to_string(limitBytes));
    }
    std::vector<std::byte> bytes;
    try {
        bytes.resize(size);
    } catch (const std::exception&) {
        file.refuse("has " + std::to_string(size) + " bytes, which do not fit into memory");
    }
    file.fill(bytes);
    return bytes;
}

}  // namespace ribalta
