// FileNode: a node as the file has it, its members found once. What they mean is its readers'
// matter.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace ribalta::gltf {

/// Points into the document. What the node lacks is empty, nullptr or -1.
struct FileNode {
    const nlohmann::json* object = nullptr;
    std::string_view name;
    std::span<const nlohmann::json> children;  ///< indices of nodes
    std::span<const nlohmann::json> matrix;    ///< 16 numbers, columns first
    std::span<const nlohmann::json> translation;
    std::span<const nlohmann::json> rotation;  ///< x, y, z, w
    std::span<const nlohmann::json> scale;
    const nlohmann::json* extensions = nullptr;
    const nlohmann::json* skin = nullptr;
    const nlohmann::json* weights = nullptr;
    int mesh = -1;
    int camera = -1;

    /// The extension's object, or null.
    const nlohmann::json& extension(std::string_view key) const;
};

/// The nodes of a document that is checked and mended, and that must outlive them unchanged.
std::vector<FileNode> listNodes(const nlohmann::json& document);

/// The parent of each, -1 where it has none.
std::vector<int> parentsOf(const std::vector<FileNode>& nodes);

}  // namespace ribalta::gltf
