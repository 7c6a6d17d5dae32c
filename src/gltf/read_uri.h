// URIs as glTF allows them: relative paths inside the file's folder, and data: URIs.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace ribalta::gltf {

/// %20 and the like as the characters they stand for. A '%' that starts no such code stands for
/// itself: exporters write such names.
std::string percentDecode(std::string_view text);

bool isDataUri(std::string_view uri);

/// The bytes of a data: URI, base64 or percent-encoded, whatever its media type and parameters.
/// Throws Error(kBadInput).
std::vector<std::byte> decodeDataUri(std::string_view uri, const Place& place);

/// The file that a relative URI names. Throws Error(kBadInput) where it is absolute, has a scheme
/// such as http:, or leaves the folder, also by way of symbolic links.
std::filesystem::path resolveUri(std::string_view uri, const std::filesystem::path& folder,
                                 const Place& place, bool allowOutside = false);

/// The same for a plain path, as artists write it into custom properties: nothing is decoded.
std::filesystem::path resolvePath(const std::string& path, const std::filesystem::path& folder,
                                  const Place& place, bool allowOutside = false);

}  // namespace ribalta::gltf
