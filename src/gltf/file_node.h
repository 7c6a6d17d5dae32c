// FileNode: a node as the file has it, its members found once. What they mean is its readers'
// matter.
#pragma once

#include <memory_resource>
#include <span>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace ribalta::gltf {

/// What the node lacks is empty, nullptr or -1.
struct FileNode {
    const nlohmann::json* object = nullptr;  ///< in the tree: what it has beside, if anything
    const nlohmann::json* extensions = nullptr;
    std::string_view name;
    std::span<int> children;         ///< indices of nodes
    std::span<const double> matrix;  ///< 16, columns first
    std::span<const double> translation;
    std::span<const double> rotation;  ///< x, y, z, w
    std::span<const double> scale;
    int mesh = -1;
    int camera = -1;

    /// Another member, or the object of an extension; null where it has none.
    const nlohmann::json& other(std::string_view key) const;
    const nlohmann::json& extension(std::string_view key) const;
};

/// Reads what readPlainNodes has left of the nodes of a document, which is checked and mended and
/// must outlive them unchanged. Lists are put into `memory`.
void readOtherNodes(const nlohmann::json& document, std::pmr::memory_resource& memory,
                    std::vector<FileNode>& nodes);

/// The parent of each, -1 where it has none.
std::vector<int> parentsOf(const std::vector<FileNode>& nodes);

/// Room for a list.
template <typename T>
std::span<T> roomFor(std::size_t count, std::pmr::memory_resource& memory) {
    return {std::pmr::polymorphic_allocator<T>(&memory).allocate(count), count};
}

}  // namespace ribalta::gltf
