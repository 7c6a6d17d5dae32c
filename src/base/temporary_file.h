// An output that appears whole or not at all: written under a temporary name, then renamed.
#pragma once

#include <filesystem>
#include <string_view>

namespace ribalta {

/// Owns a temporary file beside `target`. Until commit() the target is untouched; a
/// TemporaryFile that goes away uncommitted removes what was written.
class TemporaryFile {
  public:
    /// Creates the temporary file. Throws Error(kJobFailed) that names `target` where its folder
    /// is missing or cannot be written, or where `target` is a folder or a device. A link is
    /// followed.
    explicit TemporaryFile(const std::filesystem::path& target);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    /// Where to write; has the target's extension.
    const std::filesystem::path& path() const { return path_; }
    /// Brings the content to the disk and renames it to the target, replacing what was there.
    /// Throws Error(kJobFailed), the target untouched.
    void commit();

  private:
    std::filesystem::path target_;
    std::filesystem::path path_;
    bool committed_ = false;
};

/// Writes `content` to `target` by way of a TemporaryFile. Throws Error(kJobFailed).
void writeFileAtomically(const std::filesystem::path& target, std::string_view content);

/// Removes the files of all TemporaryFiles there are (of the first 16, where there are more). Safe
/// in a signal handler, after which the process must end.
void removeTemporaryFiles() noexcept;

}  // namespace ribalta
