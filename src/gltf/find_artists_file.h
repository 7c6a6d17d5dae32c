// A file by the path that an artist typed into a custom property, habits forgiven.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/error.h"

namespace ribalta::gltf {

struct FoundFile {
    std::string path;  ///< relative to the scene's folder
    std::string note;  ///< how it differs from what was asked for; empty where it does not
};

/// The file in or below `folder` that is meant: as written, else without spaces or quotes around
/// it, with slashes for backslashes, without Blender's // in front, with %20 and the like decoded,
/// by its name beside the scene where the path is absolute, and at last whatever the case of its
/// letters. Nothing where none of these is there. Follows no path out of the folder,
/// unless that is allowed.
std::optional<FoundFile> findArtistsFile(const std::string& written,
                                         const std::filesystem::path& folder, bool allowOutside,
                                         const Place& place);

}  // namespace ribalta::gltf
