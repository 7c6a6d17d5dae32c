// Looks as JSON files; samples/looks/README.md describes the format.
#pragma once

#include <filesystem>

#include "look/look.h"

namespace ribalta {

/// The version of the format that is written. Older ones are read; newer ones are refused.
inline constexpr int kLookVersion = 1;

/// Light maps are found relative to the file's folder. Throws Error(kBadInput) that names the key
/// and what was expected.
Look readLook(const std::filesystem::path& path);

/// Writes the file whole or not at all; light maps relative to its folder. Throws
/// Error(kJobFailed).
void writeLook(const Look& look, const std::filesystem::path& path);

}  // namespace ribalta
