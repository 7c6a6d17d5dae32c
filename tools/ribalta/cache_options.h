// Whether, and where, what took time to make is kept from one run to the next.
#pragma once

#include <optional>

#include "base/file_cache.h"

namespace CLI {
class App;
}

namespace ribalta {

/// The flag --no-cache. Must outlive the parsing of the command it is added to.
struct CacheOptions {
    bool off = false;

    void addTo(CLI::App& command);

    /// None where it is switched off, or where there is no folder for caches; the latter is said
    /// with --verbose.
    std::optional<FileCache> cache() const;
};

}  // namespace ribalta
