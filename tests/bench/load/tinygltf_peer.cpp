// What bench_load.py compares with: a GLB through stock tinygltf with stb and Draco, as its users
// have it, and the drawn geometry copied out of its buffers. Prints how much came of it.
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_ENABLE_DRACO
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include <tiny_gltf.h>

#include "geometry_bytes.h"

namespace {

std::vector<float> floatsOf(const tinygltf::Model& model, int index) {
    const tinygltf::Accessor& accessor = model.accessors.at(std::size_t(index));
    const tinygltf::BufferView& view = model.bufferViews.at(std::size_t(accessor.bufferView));
    const auto components =
        std::size_t(tinygltf::GetNumComponentsInType(std::uint32_t(accessor.type)));
    const auto stride = std::size_t(accessor.ByteStride(view));
    const unsigned char* from = model.buffers.at(std::size_t(view.buffer)).data.data() +
                                view.byteOffset + accessor.byteOffset;
    std::vector<float> values(accessor.count * components);
    for (std::size_t i = 0; i < accessor.count; ++i) {
        std::memcpy(&values[i * components], from + i * stride, components * sizeof(float));
    }
    return values;
}

std::vector<std::uint32_t> indicesOf(const tinygltf::Model& model, int index) {
    const tinygltf::Accessor& accessor = model.accessors.at(std::size_t(index));
    const tinygltf::BufferView& view = model.bufferViews.at(std::size_t(accessor.bufferView));
    const unsigned char* from = model.buffers.at(std::size_t(view.buffer)).data.data() +
                                view.byteOffset + accessor.byteOffset;
    std::vector<std::uint32_t> values(accessor.count);
    for (std::size_t i = 0; i < accessor.count; ++i) {
        if (accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) {
            std::uint16_t value = 0;
            std::memcpy(&value, from + 2 * i, 2);
            values[i] = value;
        } else {
            std::memcpy(&values[i], from + 4 * i, 4);
        }
    }
    return values;
}

}  // namespace

int main(int, char** words) {
    tinygltf::TinyGLTF loader;
    tinygltf::Model model;
    std::string error;
    std::string warning;
    if (!loader.LoadBinaryFromFile(&model, &error, &warning, words[1])) {
        std::fprintf(stderr, "tinygltf: %s\n", error.c_str());
        return 3;
    }
    Loaded loaded;
    for (const tinygltf::Mesh& mesh : model.meshes) {
        for (const tinygltf::Primitive& primitive : mesh.primitives) {
            for (const auto& [name, accessor] : primitive.attributes) {
                loaded.keep(floatsOf(model, accessor));
            }
            loaded.keep(indicesOf(model, primitive.indices));
        }
    }
    for (const tinygltf::Image& image : model.images) {
        loaded.pixelBytes += image.image.size();
    }
    loaded.print(model.nodes.size());
    return 0;
}
