// JSON into typed glTF, by tinygltf. It reads no files and decodes nothing.
#pragma once

#include <nlohmann/json.hpp>
#include <tiny_gltf.h>

#include "base/error.h"

namespace ribalta::gltf {

/// The typed form of a checked document, index by index the same, without what Import leaves to
/// the JSON. Throws Error(kBadInput) where tinygltf refuses it all the same.
tinygltf::Model parseModel(const nlohmann::json& json, const Place& file);

}  // namespace ribalta::gltf
