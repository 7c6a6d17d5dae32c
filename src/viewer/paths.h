// Paths as people mean them.
#pragma once

#include <filesystem>
#include <vector>

namespace ribalta {

/// Absolute, without . and .. in it: paths that name one file alike.
std::filesystem::path plainPath(const std::filesystem::path& file);

/// Whether there is such a file; not where it cannot be told.
bool isThere(const std::filesystem::path& file);

/// Whether one of the files is this one, by whatever path.
bool isAmong(const std::filesystem::path& file, const std::vector<std::filesystem::path>& files);

/// Where a look lies unless it is said: beside its scene.
std::filesystem::path lookBeside(const std::filesystem::path& scene);

}  // namespace ribalta
