#include "gltf/read_nodes.h"

#include <cmath>
#include <utility>

#include <glm/gtc/quaternion.hpp>

#include "gltf/bad_input.h"
#include "gltf/where.h"

namespace ribalta::gltf {
namespace {

constexpr const char* kVisibility = "KHR_node_visibility";

bool isUsable(const glm::dmat4& matrix) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!(std::abs(matrix[column][row]) <= kMaxTransform)) {
                return false;
            }
        }
    }
    return true;
}

using Numbers = std::span<const double>;

glm::dmat4 matrixOf(Numbers numbers) {
    glm::dmat4 matrix;
    for (int i = 0; i < 16; ++i) {
        matrix[i / 4][i % 4] = numbers[std::size_t(i)];
    }
    return matrix;
}

glm::dquat rotationOf(Numbers numbers, const Where& where, Report& report) {
    const glm::dquat rotation(numbers[3], numbers[0], numbers[1], numbers[2]);
    const double length = glm::length(rotation);
    if (!(length > 1e-6) || !std::isfinite(length)) {
        report.repaired(where.place().at("rotation"), "is no rotation; the node is not turned");
        return {1.0, 0.0, 0.0, 0.0};
    }
    if (std::abs(length - 1.0) > 1e-2) {
        report.repaired(where.place().at("rotation"), "has the length " + std::to_string(length) +
                                                          ", expected 1; it is brought to that");
    }
    return rotation / length;
}

Pose poseOf(const FileNode& source, const Where& where, Report& report) {
    Pose pose;
    if (!source.rotation.empty()) {
        pose.rotation = rotationOf(source.rotation, where, report);
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (!source.scale.empty()) {
            pose.scale[axis] = source.scale[std::size_t(axis)];
        }
        if (!source.translation.empty()) {
            pose.translation[axis] = source.translation[std::size_t(axis)];
        }
    }
    return pose;
}

glm::dmat4 transformOf(const FileNode& source, const Where& where, Report& report) {
    glm::dmat4 matrix(1.0);
    if (!source.matrix.empty()) {
        matrix = matrixOf(source.matrix);
        const bool isAffine = matrix[0][3] == 0.0 && matrix[1][3] == 0.0 && matrix[2][3] == 0.0 &&
                              matrix[3][3] == 1.0;
        if (!isAffine) {
            report.repaired(where.place().at("matrix"),
                            "has a last row other than 0 0 0 1, which is used instead");
            matrix[0][3] = matrix[1][3] = matrix[2][3] = 0.0;
            matrix[3][3] = 1.0;
        }
    } else {
        matrix = poseOf(source, where, report).parentFromLocal();
    }
    if (!isUsable(matrix)) {
        report.repaired(where.place(),
                        "has a transform with numbers out of all bounds; it is placed as "
                        "its parent is");
        return glm::dmat4(1.0);
    }
    return matrix;
}

// Places the nodes, in the file's units, and mends what could be placed on its own, but not below
// its parents.
void placeBelowParents(NodeList& list, const Import& import, Report& report) {
    for (std::size_t i = 0; i < list.nodes.size(); ++i) {
        Node& node = list.nodes[i];
        node.worldFromLocal = node.parentFromLocal;
        if (node.parent < 0) {
            continue;
        }
        const glm::dmat4& parent = list.nodes[std::size_t(node.parent)].worldFromLocal;
        node.worldFromLocal = parent * node.parentFromLocal;
        if (!isUsable(node.worldFromLocal)) {
            report.repaired(import.file.at("nodes").at(list.gltfNodes[i]),
                            "has a transform that together with its parents' is out of "
                            "all bounds; it is placed as its parent is");
            node.parentFromLocal = glm::dmat4(1.0);
            node.worldFromLocal = parent;
        }
    }
}

}  // namespace

NodeList readNodes(const Import& import, const std::vector<std::size_t>& roots, Report& report) {
    NodeList list;
    list.nodes.reserve(import.nodes.size());
    list.gltfNodes.reserve(import.nodes.size());
    const Where root(import.file);
    const Where where(root, "nodes");
    // A stack of nodes to visit with their parents; check_nodes made sure that it is a forest.
    std::vector<std::pair<std::size_t, int>> open;
    for (std::size_t i = roots.size(); i-- > 0;) {
        open.emplace_back(roots[i], -1);
    }
    while (!open.empty()) {
        const auto [index, parent] = open.back();
        open.pop_back();
        const FileNode& source = import.nodes[index];
        const auto self = int(list.nodes.size());
        Node& node = list.nodes.emplace_back();
        node.name = source.name;
        node.parent = parent;
        node.parentFromLocal = transformOf(source, Where(where, index), report);
        node.mesh = source.mesh;
        node.visible = member(source.extension(kVisibility), "visible") != false;
        list.gltfNodes.push_back(index);
        for (std::size_t i = source.children.size(); i-- > 0;) {
            open.emplace_back(std::size_t(source.children[i]), self);
        }
    }
    placeBelowParents(list, import, report);
    list.inScene = list.nodes.size();
    return list;
}

JointFinder::JointFinder(const Import& import, NodeList& list, Report& report)
    : import_(import),
      list_(list),
      report_(report),
      parents_(parentsOf(import.nodes)),
      placed_(parents_.size(), -1) {
    for (std::size_t i = list.nodes.size(); i-- > 0;) {
        placed_[list.gltfNodes[i]] = int(i);
    }
}

int JointFinder::find(std::size_t joint) {
    const Where root(import_.file);
    const Where nodes(root, "nodes");
    std::vector<int> path;
    for (int node = int(joint); node >= 0 && placed_[std::size_t(node)] < 0;
         node = parents_[std::size_t(node)]) {
        path.push_back(node);
    }
    for (std::size_t step = path.size(); step-- > 0;) {
        const auto index = std::size_t(path[step]);
        const int parent = parents_[index];
        placed_[index] = int(list_.nodes.size());
        Node& node = list_.nodes.emplace_back();
        node.name = import_.nodes[index].name;
        node.parent = parent < 0 ? -1 : placed_[std::size_t(parent)];
        node.parentFromLocal = transformOf(import_.nodes[index], Where(nodes, index), report_);
        list_.gltfNodes.push_back(index);
    }
    return placed_[joint];
}

void JointFinder::finish() {
    if (list_.nodes.size() > list_.inScene) {
        placeBelowParents(list_, import_, report_);
    }
}

std::optional<Pose> restPoseOf(const Import& import, const NodeList& list, std::size_t node) {
    const std::size_t index = list.gltfNodes[node];
    const FileNode& source = import.nodes[index];
    Report told;  // by readNodes already
    const Pose pose = poseOf(source, Where(import.file), told);
    const bool isWhole =
        source.matrix.empty() && pose.parentFromLocal() == list.nodes[node].parentFromLocal;
    return isWhole ? std::optional<Pose>(pose) : std::nullopt;
}

void leaveOutVanished(NodeList& list, const std::vector<Mover>& movers, const Import& import,
                      Report& report) {
    std::vector<char> moves(list.nodes.size(), 0);
    for (const Mover& mover : movers) {
        moves[std::size_t(mover.node)] = 1;
    }
    // What joints place stands behind the scene's own nodes, and is not its parent's size.
    for (std::size_t i = 0; i < list.inScene; ++i) {
        Node& node = list.nodes[i];
        if (node.parent >= 0) {
            moves[i] = char(moves[i] | moves[std::size_t(node.parent)]);
        }
        if (node.mesh >= 0 && moves[i] == 0 && vanishes(node.worldFromLocal)) {
            report.ignored(import.file.at("nodes").at(list.gltfNodes[i]),
                           "is scaled to nothing; its mesh is not drawn");
            node.mesh = -1;
        }
    }
}

}  // namespace ribalta::gltf
