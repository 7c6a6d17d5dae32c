// Whether, and where, what took time to make is kept from one run to the next.
#pragma once

#include <optional>
#include <string>

#include "base/file_cache.h"

namespace CLI {
class App;
}

namespace ribalta {

/// The options --no-cache and --cache-limit. Must outlive the parsing of the command it is added
/// to.
struct CacheOptions {
    bool off = false;
    std::optional<std::string> limit;

    void addTo(CLI::App& command);

    /// None where it is switched off, or where there is no folder for caches; the latter is said
    /// with --verbose. Throws CLI::ValidationError where the limit is no number of bytes.
    std::optional<FileCache> cache() const;
};

}  // namespace ribalta
