// What becomes of many files when they are loaded: a table, one line a file. For pipelines, and for
// whoever looks after a library of models.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "gltf/load_options.h"

namespace ribalta {

/// How many files ended which way.
struct OutcomeCounts {
    std::size_t loaded = 0;
    std::size_t reported = 0;  ///< loaded, with something to report
    std::size_t refused = 0;
};

/// Loads each file, and in a folder and below it every .gltf and .glb in the order of their paths.
/// Prints path, outcome (loaded, reported, refused) and the first message, parted by tabs, on
/// stdout as soon as it is known. Throws Error(kBadInput) where a folder cannot be looked through
/// or has no such file.
OutcomeCounts printOutcomes(const std::vector<std::string>& paths, const LoadOptions& options);

}  // namespace ribalta
