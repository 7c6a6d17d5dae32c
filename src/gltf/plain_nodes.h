// The nodes of which a document's tree is spared: most of those of a file that has many.
#pragma once

#include <functional>
#include <memory_resource>
#include <vector>

#include "gltf/file_node.h"

namespace simdjson::dom {
class element;
}

namespace ribalta::gltf {

/// Reads the plain nodes of a document that nobody has checked: those whose members all keep the
/// rules, and that have neither extensions nor skins, weights and what glTF 2.0 does not know.
/// Returns by node whether it is one. `expect` is told how many nodes there are before memory is
/// taken for them.
std::vector<char> readPlainNodes(const simdjson::dom::element& document,
                                 const std::function<void(std::size_t)>& expect,
                                 std::pmr::memory_resource& memory, std::vector<FileNode>& nodes);

}  // namespace ribalta::gltf
