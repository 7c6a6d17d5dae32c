#include "gltf/file_node.h"

#include <string>

#include "gltf/import.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

template <typename T>
std::span<T> listOf(const json& array, std::pmr::memory_resource& memory) {
    const std::span<T> list = roomFor<T>(array.size(), memory);
    for (std::size_t i = 0; i < list.size(); ++i) {
        list[i] = array[i].get<T>();
    }
    return list;
}

// Members that are there are of the right type.
void readMembers(const json& object, std::pmr::memory_resource& memory, FileNode& node) {
    node.object = &object;
    for (const auto& [name, value] : object.get_ref<const json::object_t&>()) {
        const std::string_view key = name;
        if (key == "name") {
            node.name = value.get_ref<const std::string&>();
        } else if (key == "children") {
            node.children = listOf<int>(value, memory);
        } else if (key == "matrix") {
            node.matrix = listOf<double>(value, memory);
        } else if (key == "translation") {
            node.translation = listOf<double>(value, memory);
        } else if (key == "rotation") {
            node.rotation = listOf<double>(value, memory);
        } else if (key == "scale") {
            node.scale = listOf<double>(value, memory);
        } else if (key == "extensions") {
            node.extensions = &value;
        } else if (key == "mesh") {
            node.mesh = value.get<int>();
        } else if (key == "camera") {
            node.camera = value.get<int>();
        }
    }
}

}  // namespace

const json& FileNode::other(std::string_view key) const {
    static const json kNull;
    return object == nullptr ? kNull : member(*object, key);
}

const json& FileNode::extension(std::string_view key) const {
    static const json kNull;
    return extensions == nullptr ? kNull : member(*extensions, key);
}

void readOtherNodes(const json& document, std::pmr::memory_resource& memory,
                    std::vector<FileNode>& nodes) {
    const json& objects = member(document, "nodes");
    nodes.resize(objects.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!objects[i].is_discarded()) {
            readMembers(objects[i], memory, nodes[i]);
        }
    }
}

std::vector<int> parentsOf(const std::vector<FileNode>& nodes) {
    std::vector<int> parents(nodes.size(), -1);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (const int child : nodes[i].children) {
            parents[std::size_t(child)] = int(i);
        }
    }
    return parents;
}

}  // namespace ribalta::gltf
