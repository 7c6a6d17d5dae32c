// Small glTF files written by tests, and what came of loading them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "gltf/load_gltf.h"
#include "support/test_folder.h"

namespace ribalta::test {

/// Component types of accessors (glTF 2.0, 3.6.2.2).
inline constexpr int kByte = 5120;
inline constexpr int kUnsignedByte = 5121;
inline constexpr int kShort = 5122;
inline constexpr int kUnsignedShort = 5123;
inline constexpr int kUnsignedInt = 5125;
inline constexpr int kFloat = 5126;

/// A document with one buffer, put together by hand. `json` may be changed at will; the buffer is
/// written into it as a data URI when the file is.
class GltfFile {
  public:
    /// An empty scene: asset, scene 0 without nodes.
    GltfFile();

    nlohmann::json json;

    /// Appends numbers to the buffer and describes them by a bufferView. Returns its index.
    template <typename T>
    int addView(const std::vector<T>& numbers) {
        return addViewBytes(numbers.data(), numbers.size() * sizeof(T));
    }
    int addViewBytes(const void* bytes, std::size_t size);
    /// Adds an accessor of all of a new bufferView. Returns its index.
    template <typename T>
    int addAccessor(const std::vector<T>& numbers, const std::string& type, int componentType,
                    std::size_t count) {
        return push("accessors", {{"bufferView", addView(numbers)},
                                  {"componentType", componentType},
                                  {"type", type},
                                  {"count", count}});
    }
    int addPositions(const std::vector<float>& xyz);
    /// Appends to a top-level array. Returns the index.
    int push(const std::string& array, const nlohmann::json& object);
    /// Adds a node to the scene. Returns its index.
    int addNode(const nlohmann::json& node);
    /// Adds one mesh of one primitive on one node. Returns the mesh's index.
    int addMesh(const nlohmann::json& primitive);

    std::string text() const;
    std::vector<std::byte> glb() const;
    std::filesystem::path writeTo(const TestFolder& folder) const;

    /// The file's buffer as it stands.
    const std::vector<std::byte>& bytes() const { return bytes_; }

  private:
    std::vector<std::byte> bytes_;
};

/// A GltfFile with one triangle (0,0,0) (1,0,0) (0,1,0) without indices.
GltfFile triangleFile();

std::string base64(const std::vector<std::byte>& bytes);

/// Loads the file and fails the test where the scene breaks a promise of its headers.
LoadedScene load(const GltfFile& file);
LoadedScene load(const std::filesystem::path& path);

/// Fails the test unless loading ends in Error(kBadInput) at this pointer, with all the words.
void expectRefused(const GltfFile& file, const std::string& pointer,
                   const std::vector<std::string>& words);
void expectRefused(const std::filesystem::path& path, const std::string& pointer,
                   const std::vector<std::string>& words);

/// Fails the test unless the report has a line of this kind at this pointer with the word.
void expectLine(const LoadedScene& loaded, Report::Kind kind, const std::string& pointer,
                const std::string& word);

/// The report as text, for messages.
std::string reportText(const LoadedScene& loaded);

/// The first primitive of the first mesh.
const Primitive& onlyPrimitive(const LoadedScene& loaded);

}  // namespace ribalta::test
