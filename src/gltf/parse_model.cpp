#include <nlohmann/json.hpp>

#define TINYGLTF_IMPLEMENTATION
#include <array>
#include <string>
#include <utility>

#include "gltf/bad_input.h"
#include "gltf/parse_model.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

// Only these members are handed on; the rest is read elsewhere, or is what tinygltf refuses or
// crashes on: buffers without a URI, images past their buffer, Draco data, nested extras.
const std::pair<const char*, std::vector<const char*>> kArrays[] = {
    {"scenes", {"name", "nodes"}},
    {"nodes", {"name", "children", "matrix", "translation", "rotation", "scale", "mesh", "camera"}},
    {"accessors",
     {"bufferView", "byteOffset", "componentType", "count", "type", "normalized", "sparse"}},
    {"bufferViews", {"buffer", "byteOffset", "byteLength", "byteStride"}},
    {"materials",
     {"name", "pbrMetallicRoughness", "normalTexture", "occlusionTexture", "emissiveTexture",
      "emissiveFactor", "alphaMode", "alphaCutoff", "doubleSided"}},
    {"textures", {"name", "sampler", "source"}},
    {"samplers", {"name", "magFilter", "minFilter", "wrapS", "wrapT"}},
};

json pick(const json& object, const std::vector<const char*>& keys) {
    json picked = json::object();
    for (const char* key : keys) {
        const auto found = object.find(key);
        if (found != object.end()) {
            picked[key] = *found;
        }
    }
    return picked;
}

json pickMeshes(const json& meshes) {
    json picked = json::array();
    for (const json& mesh : meshes) {
        json copy = pick(mesh, {"name"});
        copy["primitives"] = json::array();
        for (const json& primitive : mesh.at("primitives")) {
            copy["primitives"].push_back(
                pick(primitive, {"attributes", "indices", "material", "mode"}));
        }
        picked.push_back(std::move(copy));
    }
    return picked;
}

// tinygltf refuses indices whose accessor has no bufferView, which glTF allows: such accessors
// point to a placeholder while it reads. Returns the placeholder's index.
std::size_t addPlaceholderView(json& reduced) {
    json& views = reduced["bufferViews"];
    if (!views.is_array()) {
        views = json::array();
    }
    const std::size_t placeholder = views.size();
    views.push_back({{"buffer", 0}, {"byteLength", 1}});
    for (json& accessor : reduced["accessors"]) {
        if (!accessor.contains("bufferView")) {
            accessor["bufferView"] = placeholder;
        }
    }
    return placeholder;
}

}  // namespace

tinygltf::Model parseModel(const json& document, const Place& file) {
    json reduced;
    reduced["asset"] = {{"version", "2.0"}};
    for (const auto& [array, keys] : kArrays) {
        const auto found = document.find(array);
        if (found == document.end()) {
            continue;
        }
        json& target = reduced[array] = json::array();
        for (const json& object : *found) {
            target.push_back(pick(object, keys));
        }
    }
    if (document.contains("meshes")) {
        reduced["meshes"] = pickMeshes(document["meshes"]);
    }
    const std::size_t placeholder = addPlaceholderView(reduced);

    tinygltf::TinyGLTF parser;
    parser.SetFsCallbacks({});
    tinygltf::Model model;
    std::string error;
    std::string warning;
    const std::string text = reduced.dump();
    if (!parser.LoadASCIIFromString(&model, &error, &warning, text.data(),
                                    static_cast<unsigned int>(text.size()), "",
                                    tinygltf::NO_REQUIRE)) {
        badInput(file, "cannot be parsed: " + error + "; export the file again");
    }
    model.bufferViews.pop_back();
    for (tinygltf::Accessor& accessor : model.accessors) {
        if (accessor.bufferView == int(placeholder)) {
            accessor.bufferView = -1;
        }
    }
    return model;
}

}  // namespace ribalta::gltf
