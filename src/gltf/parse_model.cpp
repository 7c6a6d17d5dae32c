#include "gltf/parse_model.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "gltf/import.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

// Members that are there are of the right type; those that are not leave tinygltf's default.
template <typename T>
void take(const json& object, const char* key, T& value) {
    const auto found = object.find(key);
    if (found != object.end()) {
        found->get_to(value);
    }
}

void takeScene(const json& source, tinygltf::Scene& scene) {
    take(source, "name", scene.name);
    take(source, "nodes", scene.nodes);
}

int accessorType(const std::string& name) {
    constexpr std::pair<const char*, int> kTypes[] = {
        {"SCALAR", TINYGLTF_TYPE_SCALAR}, {"VEC2", TINYGLTF_TYPE_VEC2},
        {"VEC3", TINYGLTF_TYPE_VEC3},     {"VEC4", TINYGLTF_TYPE_VEC4},
        {"MAT2", TINYGLTF_TYPE_MAT2},     {"MAT3", TINYGLTF_TYPE_MAT3},
        {"MAT4", TINYGLTF_TYPE_MAT4},
    };
    for (const auto& [known, type] : kTypes) {
        if (name == known) {
            return type;
        }
    }
    return -1;
}

void takeAccessor(const json& source, tinygltf::Accessor& accessor) {
    take(source, "bufferView", accessor.bufferView);
    take(source, "byteOffset", accessor.byteOffset);
    take(source, "componentType", accessor.componentType);
    take(source, "count", accessor.count);
    take(source, "normalized", accessor.normalized);
    accessor.type = accessorType(member(source, "type").get_ref<const std::string&>());
    const json& sparse = member(source, "sparse");
    accessor.sparse = {};
    if (sparse.is_null()) {
        return;
    }
    accessor.sparse.isSparse = true;
    take(sparse, "count", accessor.sparse.count);
    const json& indices = member(sparse, "indices");
    take(indices, "bufferView", accessor.sparse.indices.bufferView);
    take(indices, "byteOffset", accessor.sparse.indices.byteOffset);
    take(indices, "componentType", accessor.sparse.indices.componentType);
    const json& values = member(sparse, "values");
    take(values, "bufferView", accessor.sparse.values.bufferView);
    take(values, "byteOffset", accessor.sparse.values.byteOffset);
}

void takeBufferView(const json& source, tinygltf::BufferView& view) {
    take(source, "buffer", view.buffer);
    take(source, "byteOffset", view.byteOffset);
    take(source, "byteLength", view.byteLength);
    take(source, "byteStride", view.byteStride);
}

// Which texture a slot has is read from the JSON.
void takeMaterial(const json& source, tinygltf::Material& material) {
    take(source, "name", material.name);
    const json& pbr = member(source, "pbrMetallicRoughness");
    if (!pbr.is_null()) {
        take(pbr, "baseColorFactor", material.pbrMetallicRoughness.baseColorFactor);
        take(pbr, "metallicFactor", material.pbrMetallicRoughness.metallicFactor);
        take(pbr, "roughnessFactor", material.pbrMetallicRoughness.roughnessFactor);
    }
    const json& normal = member(source, "normalTexture");
    if (!normal.is_null()) {
        take(normal, "scale", material.normalTexture.scale);
    }
    const json& occlusion = member(source, "occlusionTexture");
    if (!occlusion.is_null()) {
        take(occlusion, "strength", material.occlusionTexture.strength);
    }
    material.emissiveFactor = {0.0, 0.0, 0.0};
    take(source, "emissiveFactor", material.emissiveFactor);
    take(source, "alphaMode", material.alphaMode);
    take(source, "alphaCutoff", material.alphaCutoff);
    take(source, "doubleSided", material.doubleSided);
}

void takeTexture(const json& source, tinygltf::Texture& texture) {
    take(source, "sampler", texture.sampler);
    take(source, "source", texture.source);
}

void takeSampler(const json& source, tinygltf::Sampler& sampler) {
    take(source, "magFilter", sampler.magFilter);
    take(source, "minFilter", sampler.minFilter);
    take(source, "wrapS", sampler.wrapS);
    take(source, "wrapT", sampler.wrapT);
}

void takeMesh(const json& source, tinygltf::Mesh& mesh) {
    take(source, "name", mesh.name);
    const json& primitives = member(source, "primitives");
    mesh.primitives.resize(primitives.size());
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        tinygltf::Primitive& primitive = mesh.primitives[i];
        primitive.mode = TINYGLTF_MODE_TRIANGLES;
        take(primitives[i], "attributes", primitive.attributes);
        take(primitives[i], "indices", primitive.indices);
        take(primitives[i], "material", primitive.material);
        take(primitives[i], "mode", primitive.mode);
    }
}

template <typename T, typename TakeOne>
void takeAll(const json& document, const char* key, std::vector<T>& list, const TakeOne& takeOne) {
    const json& sources = member(document, key);
    list.resize(sources.size());
    for (std::size_t i = 0; i < sources.size(); ++i) {
        takeOne(sources[i], list[i]);
    }
}

}  // namespace

tinygltf::Model parseModel(const json& document) {
    tinygltf::Model model;
    takeAll(document, "scenes", model.scenes, takeScene);
    takeAll(document, "accessors", model.accessors, takeAccessor);
    takeAll(document, "bufferViews", model.bufferViews, takeBufferView);
    takeAll(document, "materials", model.materials, takeMaterial);
    takeAll(document, "textures", model.textures, takeTexture);
    takeAll(document, "samplers", model.samplers, takeSampler);
    takeAll(document, "meshes", model.meshes, takeMesh);
    return model;
}

}  // namespace ribalta::gltf
