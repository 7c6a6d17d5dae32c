#include "base/regular_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <exception>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace ribalta {

RegularFile::RegularFile(const std::filesystem::path& path)
    : place_{path.empty() ? "''" : path.string(), ""} {
    // Without O_NONBLOCK a pipe would be waited for; a terminal is not to become this program's
    // own.
    descriptor_ =
        path.empty() ? -1 : open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    const int reason = path.empty() ? ENOENT : errno;
    if (descriptor_ < 0) {
        if (reason == ENOENT || reason == ENOTDIR) {
            refuse("no such file; check the path");
        }
        // A socket, or a device that nothing answers for.
        if (reason == ENXIO || reason == ENODEV) {
            refuse("is not a regular file; give a file");
        }
        refuse(std::string("cannot be opened: ") + std::strerror(reason));
    }
    try {
        opened_ = status();
        if (!S_ISREG(opened_.st_mode)) {
            refuse("is not a regular file; give a file");
        }
    } catch (const Error&) {
        close(descriptor_);
        throw;
    }
}

RegularFile::~RegularFile() {
    if (descriptor_ >= 0) {
        close(descriptor_);
    }
}

RegularFile::RegularFile(RegularFile&& other) noexcept
    : place_(std::move(other.place_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      opened_(other.opened_) {}

RegularFile& RegularFile::operator=(RegularFile&& other) noexcept {
    std::swap(place_, other.place_);
    std::swap(descriptor_, other.descriptor_);
    std::swap(opened_, other.opened_);
    return *this;
}

struct stat RegularFile::status() const {
    struct stat now {};
    if (fstat(descriptor_, &now) != 0) {
        refuse(std::string("cannot be opened: ") + std::strerror(errno));
    }
    return now;
}

bool RegularFile::hasChanged() const {
    const struct stat now = status();
    return now.st_size != opened_.st_size || now.st_mtim.tv_sec != opened_.st_mtim.tv_sec ||
           now.st_mtim.tv_nsec != opened_.st_mtim.tv_nsec;
}

std::uint64_t RegularFile::sizeWithin(std::uint64_t limitBytes, std::uint64_t wantedBytes) const {
    const std::uint64_t wanted = std::min(size(), wantedBytes);
    if (wanted > limitBytes) {
        refuse("has " + std::to_string(wanted) + " bytes, over the limit of " +
               std::to_string(limitBytes));
    }
    return wanted;
}

std::vector<std::byte> RegularFile::read(std::uint64_t size) const {
    constexpr std::size_t kMostAtOnce = std::size_t(1) << 30U;
    std::vector<std::byte> bytes;
    try {
        bytes.resize(size);
    } catch (const std::exception&) {
        refuse("has " + std::to_string(size) + " bytes, which do not fit into memory");
    }
    for (std::size_t at = 0; at < bytes.size();) {
        const ssize_t count =
            pread(descriptor_, &bytes[at], std::min(bytes.size() - at, kMostAtOnce), off_t(at));
        if (count == 0) {
            refuse(kChangedWhileRead);
        }
        if (count < 0 && errno != EINTR) {
            refuse(std::string("cannot be read: ") + std::strerror(errno) +
                   "; check its permissions and its disk");
        }
        at += count > 0 ? std::size_t(count) : 0;
    }
    return bytes;
}

void RegularFile::refuse(const std::string& message) const {
    throw Error(ErrorKind::kBadInput, place_, message);
}

}  // namespace ribalta
