// JSON into typed glTF, in tinygltf's types. It reads no files and decodes nothing.
#pragma once

#include <nlohmann/json.hpp>
#include <tiny_gltf.h>

namespace ribalta::gltf {

/// The typed form of a document that checkJson has gone over, index by index the same, without what
/// Import leaves to the JSON.
tinygltf::Model parseModel(const nlohmann::json& json);

}  // namespace ribalta::gltf
