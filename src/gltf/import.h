// Import: what the steps of one loadGltf hand to each other.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <memory_resource>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>
#include <tiny_gltf.h>

#include "base/error.h"
#include "base/mapped_file.h"
#include "gltf/budget.h"
#include "gltf/file_node.h"
#include "gltf/read_packed_views.h"

namespace ribalta::gltf {

class MeshCache;

/// The bytes behind one of the file's buffers; empty where the file gives none, as the fallback
/// buffers of EXT_meshopt_compression.
struct Buffer {
    std::optional<MappedFile> file{};    ///< where it has one of its own
    std::vector<std::byte> decoded{};    ///< of a data URI
    std::span<const std::byte> bytes{};  ///< as long as its byteLength, or empty
};

/// One glTF on its way into a Scene. `json` is checked and mended: types and indices in it are
/// right; of its nodes it has only what `nodes` lack. `model` is the same document, typed,
/// with the same indices; it has neither nodes, buffers, images, cameras, animations, skins nor
/// extensions and extras, which are read from `json`.
struct Import {
    Import();
    ~Import();
    Import(const Import&) = delete;
    Import& operator=(const Import&) = delete;

    Place file;                    ///< the file, pointer empty
    std::filesystem::path folder;  ///< what relative URIs are relative to
    bool allowOutside = false;     ///< whether they may leave it
    std::unique_ptr<Budget> budget = std::make_unique<Budget>(LoadLimits{});  ///< for all steps
    nlohmann::json json;
    std::pmr::monotonic_buffer_resource nodeMemory;
    std::vector<FileNode> nodes;  ///< all of the document's, a forest
    tinygltf::Model model;
    std::vector<Buffer> buffers;
    PackedViews packed;
    std::unique_ptr<MeshCache> meshCache{};  ///< there when meshes are read
};

/// The element `index` of a top-level array, or of nothing, as an object to look things up in.
const nlohmann::json& element(const nlohmann::json& json, std::string_view array,
                              std::size_t index);

/// The member `key` of the object, or null where it has none.
const nlohmann::json& member(const nlohmann::json& object, std::string_view key);

/// The number `key` of the object, or else another.
double numberOr(const nlohmann::json& object, std::string_view key, double otherwise);

/// The object `extensions/name` of an object, or null.
const nlohmann::json& extension(const nlohmann::json& object, std::string_view name);
inline constexpr const char* kLightsPunctual = "KHR_lights_punctual";

}  // namespace ribalta::gltf
