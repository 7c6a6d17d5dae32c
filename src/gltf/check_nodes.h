// Is the node hierarchy a forest? Without recursion, so that any depth is fine.
#pragma once

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/report.h"
#include "gltf/file_node.h"

namespace ribalta::gltf {

/// Throws Error(kBadInput) where nodes contain each other in a circle. A node with several parents
/// keeps the first and is taken from the others' children; a scene's root that hangs on something
/// gives way to the root above it, and none is listed twice. That is reported.
void checkNodes(std::vector<FileNode>& nodes, nlohmann::json& json, const Place& file,
                Report& report);

}  // namespace ribalta::gltf
