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

/// The drawn nodes. Their `mesh` is the glTF's index, `worldFromLocal` in the file's units.
struct NodeList {
    std::vector<Node> nodes;
    std::vector<std::size_t> gltfNodes;  ///< for each, its index in the glTF
    /// Those of the scene's hierarchy come first. What is behind them was added for joints and
    /// skinned meshes and brings neither lamps nor cameras.
    std::size_t inScene = 0;
};

/// The nodes in and below `roots`, the glTF's indices, each of which is in no other's hierarchy.
NodeList readNodes(const Import& import, const std::vector<std::size_t>& roots, Report& report);

/// Finds joints in the list, and adds those that the scene does not have, with the nodes above them
/// and without what hangs on them. All that it is given must outlive it.
class JointFinder {
  public:
    JointFinder(const Import& import, NodeList& list, Report& report);
    /// The joint's place in the list, by its index in the glTF.
    int find(std::size_t joint);
    /// To be called once when all are found: brings what was added within bounds.
    void finish();

  private:
    const Import& import_;
    NodeList& list_;
    Report& report_;
    std::vector<int> parents_;  ///< by the glTF's index
    std::vector<int> placed_;   ///< by the glTF's index, into the list; -1: not there
};

/// How the file places a node of the list, in parts; none where it has a matrix, or where its
/// transform could not be used.
std::optional<Pose> restPoseOf(const Import& import, const NodeList& list, std::size_t node);

/// Takes the meshes off nodes that are scaled to nothing and that no mover brings back.
void leaveOutVanished(NodeList& list, const std::vector<Mover>& movers, const Import& import,
                      Report& report);

}  // namespace ribalta::gltf
