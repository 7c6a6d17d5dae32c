// FileCache: what took time to make, kept in a folder from one run to the next. Losing any of it
// costs time and nothing else, so nothing here fails: what cannot be read is made again, what
// cannot be written is not kept, and --verbose says so.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ribalta {

/// $XDG_CACHE_HOME/ribalta, or ~/.cache/ribalta (XDG Base Directory Specification 0.8); none where
/// the environment names neither by an absolute path.
std::optional<std::filesystem::path> userCacheFolder();

/// Files `NAME.KEY.cache`, each with a checksum. Any number of programs may share the folder: a
/// file appears whole or not at all.
class FileCache {
  public:
    /// The folder need not be there yet. Where all files together take more than `limitBytes`,
    /// those that were used least recently are removed.
    FileCache(std::filesystem::path folder, std::uint64_t limitBytes);

    /// `name`: what it is, such as "sky"; `key`: hexadecimal digits, of all it was made from. None
    /// where nothing is kept under them, or what is kept is damaged or no file of this kind.
    std::optional<std::vector<std::byte>> find(const std::string& name,
                                               const std::string& key) const;
    void keep(const std::string& name, const std::string& key,
              std::span<const std::byte> content) const;

    const std::filesystem::path& folder() const { return folder_; }

  private:
    std::filesystem::path fileOf(const std::string& name, const std::string& key) const;
    void makeRoom() const;

    std::filesystem::path folder_;
    std::uint64_t limitBytes_;
};

}  // namespace ribalta
