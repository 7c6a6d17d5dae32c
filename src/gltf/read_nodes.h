// The hierarchy of the scene that is drawn: its nodes, parents first, and what hangs on them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/report.h"
#include "gltf/import.h"
#include "scene/node.h"

namespace ribalta::gltf {

/// The drawn nodes. Their `mesh` is the glTF's index.
struct NodeList {
    std::string sceneName;
    std::vector<Node> nodes;
    std::vector<std::size_t> gltfNodes;  ///< for each, its index in the glTF
};

/// The nodes of the default scene, or of the first, or below all roots where there is no scene.
NodeList readNodes(const Import& import, Report& report);

}  // namespace ribalta::gltf
