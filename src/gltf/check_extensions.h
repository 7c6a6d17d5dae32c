// Versions and extensions: may this file be read at all, and what of it is not drawn.
#pragma once

#include <string_view>

#include <nlohmann/json.hpp>

#include "base/error.h"

namespace ribalta::gltf {

/// Whether the import understands an extension.
bool isSupported(std::string_view extension);

/// Throws Error(kBadInput) where the document is of a version other than 2.x, needs a newer one,
/// or requires an extension that is not supported.
void checkVersionAndExtensions(const nlohmann::json& json, const Place& file);

}  // namespace ribalta::gltf
