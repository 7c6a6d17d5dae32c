#include "gltf/file_node.h"

#include <string>

#include "gltf/import.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

std::span<const json> elementsOf(const json& array) {
    return array.get_ref<const json::array_t&>();
}

// Members that are there are of the right type.
FileNode fileNode(const json& object) {
    FileNode node;
    node.object = &object;
    for (const auto& [name, value] : object.get_ref<const json::object_t&>()) {
        const std::string_view key = name;
        if (key == "name") {
            node.name = value.get_ref<const std::string&>();
        } else if (key == "children") {
            node.children = elementsOf(value);
        } else if (key == "matrix") {
            node.matrix = elementsOf(value);
        } else if (key == "translation") {
            node.translation = elementsOf(value);
        } else if (key == "rotation") {
            node.rotation = elementsOf(value);
        } else if (key == "scale") {
            node.scale = elementsOf(value);
        } else if (key == "extensions") {
            node.extensions = &value;
        } else if (key == "skin") {
            node.skin = &value;
        } else if (key == "weights") {
            node.weights = &value;
        } else if (key == "mesh") {
            node.mesh = value.get<int>();
        } else if (key == "camera") {
            node.camera = value.get<int>();
        }
    }
    return node;
}

}  // namespace

const json& FileNode::extension(std::string_view key) const {
    static const json kNull;
    return member(extensions == nullptr ? kNull : *extensions, key);
}

std::vector<FileNode> listNodes(const json& document) {
    const json& objects = member(document, "nodes");
    std::vector<FileNode> nodes;
    nodes.reserve(objects.size());
    for (const json& object : objects) {
        nodes.push_back(fileNode(object));
    }
    return nodes;
}

std::vector<int> parentsOf(const std::vector<FileNode>& nodes) {
    std::vector<int> parents(nodes.size(), -1);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (const json& child : nodes[i].children) {
            parents[child.get<std::size_t>()] = int(i);
        }
    }
    return parents;
}

}  // namespace ribalta::gltf
