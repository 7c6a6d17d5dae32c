// What bench_load.py compares with: a GLB through fastgltf, with what its users add to it: images
// through stb, Draco and meshopt through their own libraries, one after the other. Prints how much
// came of it.
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <vector>

#include <draco/compression/decode.h>
#include <draco/mesh/mesh.h>
#include <fastgltf/core.hpp>
#include <fastgltf/tools.hpp>
#include <meshoptimizer.h>
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>

#include "geometry_bytes.h"

namespace {

using Bytes = fastgltf::span<const std::byte>;

Bytes bufferBytes(const fastgltf::Asset& asset, std::size_t buffer) {
    const auto* array = std::get_if<fastgltf::sources::Array>(&asset.buffers[buffer].data);
    if (array == nullptr) {
        throw std::runtime_error("a buffer is not in memory");
    }
    return Bytes(array->bytes.data(), array->bytes.size());
}

// The views that are packed, decoded.
struct Unpacked {
    const fastgltf::Asset& asset;
    std::vector<std::vector<std::byte>> views;

    explicit Unpacked(const fastgltf::Asset& source) : asset(source) {
        views.resize(asset.bufferViews.size());
        for (std::size_t i = 0; i < views.size(); ++i) {
            const auto& packed = asset.bufferViews[i].meshoptCompression;
            if (!packed) {
                continue;
            }
            const auto* from = reinterpret_cast<const unsigned char*>(
                bufferBytes(asset, packed->bufferIndex).data() + packed->byteOffset);
            views[i].resize(packed->count * packed->byteStride);
            const int fault =
                packed->mode == fastgltf::MeshoptCompressionMode::Attributes
                    ? meshopt_decodeVertexBuffer(views[i].data(), packed->count, packed->byteStride,
                                                 from, packed->byteLength)
                    : meshopt_decodeIndexBuffer(views[i].data(), packed->count, packed->byteStride,
                                                from, packed->byteLength);
            if (fault != 0) {
                throw std::runtime_error("meshopt data is broken");
            }
        }
    }

    Bytes operator()(const fastgltf::Asset&, std::size_t index) const {
        if (!views[index].empty()) {
            return Bytes(views[index].data(), views[index].size());
        }
        const fastgltf::BufferView& view = asset.bufferViews[index];
        return bufferBytes(asset, view.bufferIndex).subspan(view.byteOffset, view.byteLength);
    }
};

template <typename Value>
std::vector<float> floatsOf(const fastgltf::Asset& asset, const fastgltf::Accessor& accessor,
                            const Unpacked& bytes) {
    std::vector<float> values(accessor.count * sizeof(Value) / sizeof(float));
    fastgltf::copyFromAccessor<Value>(asset, accessor, values.data(), bytes);
    return values;
}

void readPlain(const fastgltf::Asset& asset, const fastgltf::Primitive& primitive,
               const Unpacked& bytes, Loaded& loaded) {
    for (const fastgltf::Attribute& attribute : primitive.attributes) {
        const fastgltf::Accessor& accessor = asset.accessors[attribute.accessorIndex];
        loaded.keep(accessor.type == fastgltf::AccessorType::Vec3
                        ? floatsOf<fastgltf::math::fvec3>(asset, accessor, bytes)
                        : floatsOf<fastgltf::math::fvec2>(asset, accessor, bytes));
    }
    const fastgltf::Accessor& accessor = asset.accessors[*primitive.indicesAccessor];
    std::vector<std::uint32_t> indices(accessor.count);
    fastgltf::copyFromAccessor<std::uint32_t>(asset, accessor, indices.data(), bytes);
    loaded.keep(std::move(indices));
}

void readDraco(const fastgltf::Asset& asset, const fastgltf::DracoCompressedPrimitive& packed,
               Loaded& loaded) {
    const fastgltf::BufferView& view = asset.bufferViews[packed.bufferView];
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bufferBytes(asset, view.bufferIndex).data()) +
                    view.byteOffset,
                view.byteLength);
    auto decoded = draco::Decoder().DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok()) {
        throw std::runtime_error(decoded.status().error_msg());
    }
    const draco::Mesh& mesh = *decoded.value();
    for (const fastgltf::Attribute& wanted : packed.attributes) {
        const draco::PointAttribute* attribute =
            mesh.GetAttributeByUniqueId(std::uint32_t(wanted.accessorIndex));
        const auto components = std::size_t(attribute->num_components());
        std::vector<float> values(mesh.num_points() * components);
        for (std::uint32_t i = 0; i < mesh.num_points(); ++i) {
            attribute->GetMappedValue(draco::PointIndex(i), &values[i * components]);
        }
        loaded.keep(std::move(values));
    }
    std::vector<std::uint32_t> indices;
    indices.reserve(mesh.num_faces() * 3);
    for (std::uint32_t i = 0; i < mesh.num_faces(); ++i) {
        for (const draco::PointIndex point : mesh.face(draco::FaceIndex(i))) {
            indices.push_back(point.value());
        }
    }
    loaded.keep(std::move(indices));
}

void load(const char* path) {
    using fastgltf::Extensions;
    fastgltf::Parser parser(Extensions::KHR_draco_mesh_compression |
                            Extensions::EXT_meshopt_compression);
    auto file = fastgltf::GltfDataBuffer::FromPath(path);
    if (file.error() != fastgltf::Error::None) {
        throw std::runtime_error("cannot be read");
    }
    auto parsed = parser.loadGltf(file.get(), ".", fastgltf::Options::LoadExternalBuffers);
    if (parsed.error() != fastgltf::Error::None) {
        throw std::runtime_error(std::string(fastgltf::getErrorMessage(parsed.error())));
    }
    const fastgltf::Asset& asset = parsed.get();
    const Unpacked bytes(asset);
    Loaded loaded;
    for (const fastgltf::Mesh& mesh : asset.meshes) {
        for (const fastgltf::Primitive& primitive : mesh.primitives) {
            if (primitive.dracoCompression) {
                readDraco(asset, *primitive.dracoCompression, loaded);
            } else {
                readPlain(asset, primitive, bytes, loaded);
            }
        }
    }
    std::vector<stbi_uc*> pictures;
    for (const fastgltf::Image& image : asset.images) {
        const auto& source = std::get<fastgltf::sources::BufferView>(image.data);
        const Bytes encoded = bytes(asset, source.bufferViewIndex);
        int width = 0;
        int height = 0;
        int channels = 0;
        pictures.push_back(stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(encoded.data()),
                                                 int(encoded.size()), &width, &height, &channels,
                                                 4));
        if (pictures.back() == nullptr) {
            throw std::runtime_error(stbi_failure_reason());
        }
        loaded.pixelBytes += std::size_t(width) * std::size_t(height) * 4;
    }
    loaded.print(asset.nodes.size());
}

}  // namespace

int main(int, char** words) {
    try {
        load(words[1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "fastgltf: %s\n", error.what());
        return 3;
    }
    return 0;
}
