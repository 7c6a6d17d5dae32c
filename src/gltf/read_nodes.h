// The hierarchy of the scene that is drawn: its nodes, parents first, and what hangs on them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/report.h"
#include "gltf/import.h"
#include "scene/animation.h"
#include "scene/node.h"

namespace ribalta::gltf {

/// No number of a placement is larger. Farther away than anything and smaller than any product's
/// overflow: 1e30 m squared is finite.
inline constexpr double kMaxTransform = 1e30;

/// The drawn nodes. Their `mesh` is the glTF's index.
struct NodeList {
    std::vector<Node> nodes;
    std::vector<std::size_t> gltfNodes;  ///< for each, its index in the glTF
};

/// The nodes in and below `roots`, the glTF's indices, each of which is in no other's hierarchy.
NodeList readNodes(const Import& import, const std::vector<std::size_t>& roots, Report& report);

/// How the file places a node of the list, in parts; none where it has a matrix, or where its
/// transform could not be used.
std::optional<Pose> restPoseOf(const Import& import, const NodeList& list, std::size_t node);

/// Takes the meshes off nodes that are scaled to nothing and that no mover brings back.
void leaveOutVanished(NodeList& list, const std::vector<Mover>& movers, const Import& import,
                      Report& report);

}  // namespace ribalta::gltf
