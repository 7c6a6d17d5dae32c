#include "gltf_file.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "support/expect_error.h"
#include "support/scene_faults.h"

namespace ribalta::test {

using nlohmann::json;
using namespace nlohmann::literals;

GltfFile::GltfFile() {
    json["asset"] = {{"version", "2.0"}};
    json["scene"] = 0;
    json["scenes"] = json::array({{{"nodes", json::array()}}});
}

int GltfFile::addViewBytes(const void* bytes, std::size_t size) {
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    const std::size_t offset = bytes_.size();
    bytes_.resize(offset + size);
    std::memcpy(bytes_.data() + offset, bytes, size);
    return push("bufferViews", {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}});
}

int GltfFile::addPositions(const std::vector<float>& xyz) {
    return addAccessor(xyz, "VEC3", 5126, xyz.size() / 3);
}

int GltfFile::push(const std::string& array, const nlohmann::json& object) {
    json[array].push_back(object);
    return int(json[array].size()) - 1;
}

int GltfFile::addNode(const nlohmann::json& node) {
    const int index = push("nodes", node);
    json["scenes"][0]["nodes"].push_back(index);
    return index;
}

int GltfFile::addMesh(const nlohmann::json& primitive) {
    const int mesh = push("meshes", {{"primitives", nlohmann::json::array({primitive})}});
    addNode({{"mesh", mesh}});
    return mesh;
}

std::string GltfFile::text() const {
    nlohmann::json document = json;
    // A list that is empty is to be left out.
    if (document.contains("/scenes/0/nodes"_json_pointer) &&
        document["scenes"][0]["nodes"].empty()) {
        document["scenes"][0].erase("nodes");
    }
    if (!bytes_.empty() && !document.contains("buffers")) {
        document["buffers"] = nlohmann::json::array(
            {{{"byteLength", bytes_.size()}, {"uri", "data:;base64," + base64(bytes_)}}});
    }
    return document.dump(1);
}

std::vector<std::byte> GltfFile::glb() const {
    nlohmann::json document = json;
    document["buffers"] = nlohmann::json::array({{{"byteLength", bytes_.size()}}});
    std::string text = document.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::vector<std::byte> content = bytes_;
    content.resize((content.size() + 3) / 4 * 4);
    std::vector<std::byte> file;
    const auto put32 = [&](std::size_t number) {
        for (unsigned shift = 0; shift < 32; shift += 8) {
            file.push_back(std::byte((number >> shift) & 0xFFU));
        }
    };
    put32(0x46546C67);
    put32(2);
    put32(12 + 8 + text.size() + 8 + content.size());
    put32(text.size());
    put32(0x4E4F534A);
    const auto* chars = reinterpret_cast<const std::byte*>(text.data());
    file.insert(file.end(), chars, chars + text.size());
    put32(content.size());
    put32(0x004E4942);
    file.insert(file.end(), content.begin(), content.end());
    return file;
}

std::filesystem::path GltfFile::writeTo(const TestFolder& folder) const {
    return folder.write("scene.gltf", text());
}

GltfFile triangleFile() {
    GltfFile file;
    file.addMesh({{"attributes", {{"POSITION", file.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0})}}}});
    return file;
}

std::string base64(const std::vector<std::byte>& bytes) {
    static const char* const kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group = (group << 8U) | (i + k < bytes.size() ? unsigned(bytes[i + k]) : 0U);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text += i + k <= bytes.size() ? kDigits[(group >> (18 - 6 * k)) & 63U] : '=';
        }
    }
    return text;
}

LoadedScene load(const std::filesystem::path& path) {
    LoadedScene loaded = loadGltf(path);
    for (const std::string& fault : sceneFaults(loaded.scene)) {
        ADD_FAILURE() << fault;
    }
    for (const Report::Entry& entry : loaded.report.entries()) {
        EXPECT_EQ(entry.place.file, path.string());
    }
    return loaded;
}

LoadedScene load(const GltfFile& file) {
    const TestFolder folder;
    return load(file.writeTo(folder));
}

void expectRefused(const std::filesystem::path& path, const std::string& pointer,
                   const std::vector<std::string>& words) {
    std::vector<std::string> all = words;
    all.push_back(path.string());
    expectError(ErrorKind::kBadInput, all, [&] {
        try {
            loadGltf(path);
        } catch (const Error& error) {
            EXPECT_EQ(error.place().pointer, pointer) << error.what();
            throw;
        }
    });
}

void expectRefused(const GltfFile& file, const std::string& pointer,
                   const std::vector<std::string>& words) {
    const TestFolder folder;
    expectRefused(file.writeTo(folder), pointer, words);
}

std::string reportText(const LoadedScene& loaded) {
    std::string text;
    for (const Report::Entry& entry : loaded.report.entries()) {
        text +=
            std::string(name(entry.kind)) + " " + entry.place.pointer + ": " + entry.message + "\n";
    }
    return text;
}

void expectLine(const LoadedScene& loaded, Report::Kind kind, const std::string& pointer,
                const std::string& word) {
    const auto& entries = loaded.report.entries();
    EXPECT_TRUE(std::any_of(entries.begin(), entries.end(),
                            [&](const Report::Entry& entry) {
                                return entry.kind == kind && entry.place.pointer == pointer &&
                                       entry.message.find(word) != std::string::npos;
                            }))
        << "no line '" << name(kind) << " " << pointer << ": ..." << word << "...' in:\n"
        << reportText(loaded);
}

const Primitive& onlyPrimitive(const LoadedScene& loaded) {
    return loaded.scene.meshes.at(0).primitives.at(0);
}

}  // namespace ribalta::test
