// A file by the path that an artist typed into a custom property, or by the URI that an exporter
// wrote, habits forgiven.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/error.h"
#include "base/report.h"

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

/// Says at `place` which file is used for the one that was asked for; nothing where it is that.
void tellOfFound(const std::string& written, const FoundFile& found, const Place& place,
                 Report& report);

/// The file that a URI names or, where that is not there, the one that is meant as above, which is
/// reported. Where there is neither, what resolveUri says: an Error(kBadInput), or the path of a
/// file that is missing.
std::filesystem::path findUri(const std::string& uri, const std::filesystem::path& folder,
                              bool allowOutside, const Place& place, Report& report);

}  // namespace ribalta::gltf
