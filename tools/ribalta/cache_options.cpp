#include "cache_options.h"

#include <CLI/CLI.hpp>

#include "base/log.h"

namespace ribalta {
namespace {

/// Some hundred skies.
constexpr std::uint64_t kLimitBytes = std::uint64_t(256) << 20;

}  // namespace

void CacheOptions::addTo(CLI::App& command) {
    command.add_flag("--no-cache", off,
                     "make the sky's tables anew and keep none; otherwise they are kept in "
                     "$XDG_CACHE_HOME/ribalta or ~/.cache/ribalta, 256 MiB at most");
}

std::optional<FileCache> CacheOptions::cache() const {
    if (off) {
        return std::nullopt;
    }
    const std::optional<std::filesystem::path> folder = userCacheFolder();
    if (!folder) {
        logVerbose("cache: neither XDG_CACHE_HOME nor HOME names a folder; nothing is kept");
        return std::nullopt;
    }
    return FileCache(*folder, kLimitBytes);
}

}  // namespace ribalta
