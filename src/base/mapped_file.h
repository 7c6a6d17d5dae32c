// MappedFile: a regular file's bytes without a copy of them, for files of many megabytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "base/regular_file.h"

namespace ribalta {

/// Files from this size on are mapped into memory; smaller ones are read, which is faster.
inline constexpr std::uint64_t kMappedFrom = std::uint64_t(1) << 20;

/// Shares the system's copy of the file, so the bytes change where another program writes to it:
/// who checks a byte and then looks at it again must copy it first, and what was made of the bytes
/// counts only once expectUnchanged() has returned. Where the file is cut short, what is missing
/// reads as zeros instead of ending the process (SIGBUS).
class MappedFile {
  public:
    /// The first `wantedBytes` of `path`, or all where it has fewer. Throws as readFile does.
    explicit MappedFile(const std::filesystem::path& path,
                        std::uint64_t limitBytes = std::uint64_t(1) << 36,
                        std::uint64_t wantedBytes = UINT64_MAX);
    ~MappedFile();
    MappedFile(MappedFile&& other) noexcept;
    MappedFile& operator=(MappedFile&& other) noexcept;
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;

    std::span<const std::byte> bytes() const { return bytes_; }

    /// Throws Error(kBadInput) where the file has been written to, or could not be read to its end,
    /// while its bytes were looked at.
    void expectUnchanged() const;

  private:
    bool map(std::size_t size);

    std::optional<RegularFile> file_;  ///< that is mapped; none where it was read
    std::vector<std::byte> read_;
    std::span<const std::byte> bytes_;
    int guard_ = -1;  ///< which of the guarded ranges it is; -1 where it was read
};

}  // namespace ribalta
