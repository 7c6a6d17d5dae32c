// RegularFile: an open regular file. What kind of file it is, and how large, is asked of the open
// file: a name may stand for another one a moment later.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <sys/stat.h>

#include "base/error.h"

namespace ribalta {

class RegularFile {
  public:
    /// Opens it for reading. Throws Error(kBadInput) that names the path where it does not exist,
    /// is no regular file (a folder, a device, a pipe), or cannot be opened.
    explicit RegularFile(const std::filesystem::path& path);
    ~RegularFile();
    RegularFile(RegularFile&& other) noexcept;
    RegularFile& operator=(RegularFile&& other) noexcept;
    RegularFile(const RegularFile&) = delete;
    RegularFile& operator=(const RegularFile&) = delete;

    /// As it was when it was opened, in bytes.
    std::uint64_t size() const { return std::uint64_t(opened_.st_size); }
    int descriptor() const { return descriptor_; }
    const Place& place() const { return place_; }

    /// Whether it has been written to since it was opened, to the file system's precision.
    bool hasChanged() const;
    /// Its size, or what is wanted of it. Throws Error(kBadInput) where that is over the limit.
    std::uint64_t sizeWithin(std::uint64_t limitBytes, std::uint64_t wantedBytes) const;
    /// Its first `size` bytes. Throws Error(kBadInput) where it has become shorter, cannot be read,
    /// or does not fit into memory.
    std::vector<std::byte> read(std::uint64_t size) const;
    /// Throws Error(kBadInput) that names the path.
    [[noreturn]] void refuse(const std::string& message) const;

  private:
    struct stat status() const;

    Place place_;
    int descriptor_ = -1;
    struct stat opened_ {};
};

/// Why a file that changes cannot be read.
inline constexpr const char* kChangedWhileRead =
    "changed while it was read; try again when it is written";

}  // namespace ribalta
