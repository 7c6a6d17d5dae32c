// What nodes have that a document's tree is spared: most of what a file of many nodes holds.
#pragma once

#include <functional>
#include <memory_resource>
#include <span>
#include <string_view>
#include <vector>

#include "base/parse_json.h"
#include "gltf/file_node.h"

namespace ribalta::gltf {

/// The members that place a node and say what hangs there.
std::span<const std::string_view> plainMembers();

/// Reads the plain members of nodes that nobody has checked, of those nodes where all of them keep
/// the rules. Returns by node what is left of it. `expect` is told how many nodes there are before
/// memory is taken for them.
std::vector<JsonShare> readPlainNodes(const simdjson::dom::element& document,
                                      const std::function<void(std::size_t)>& expect,
                                      std::pmr::memory_resource& memory,
                                      std::vector<FileNode>& nodes);

}  // namespace ribalta::gltf
