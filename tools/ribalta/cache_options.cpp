#include "cache_options.h"

#include <CLI/CLI.hpp>

#include "base/log.h"
#include "parse_number.h"

namespace ribalta {
namespace {

/// Some hundred skies, or a dozen stages.
constexpr std::uint64_t kLimitBytes = 256'000'000;

}  // namespace

void CacheOptions::addTo(CLI::App& command) {
    command.add_flag("--no-cache", off,
                     "make the sky's tables and decode Draco meshes anew and keep none; otherwise "
                     "they are kept in $XDG_CACHE_HOME/ribalta or ~/.cache/ribalta");
    command
        .add_option("--cache-limit", limit,
                    "bytes that all that is kept may take; K, M, G are thousands, millions, "
                    "billions; what was used least recently goes first (default: 256M)")
        ->type_name("BYTES")
        ->excludes("--no-cache");
}

std::optional<FileCache> CacheOptions::cache() const {
    std::uint64_t bytes = kLimitBytes;
    if (limit) {
        const std::optional<std::uint64_t> given = parseCount(*limit);
        if (!given) {
            throw CLI::ValidationError(
                "--cache-limit", "'" + *limit + "' is no number of bytes, such as 500M or 2G");
        }
        bytes = *given;
    }
    if (off) {
        return std::nullopt;
    }
    const std::optional<std::filesystem::path> folder = userCacheFolder();
    if (!folder) {
        logVerbose("cache: neither XDG_CACHE_HOME nor HOME names a folder; nothing is kept");
        return std::nullopt;
    }
    return FileCache(*folder, bytes);
}

}  // namespace ribalta
