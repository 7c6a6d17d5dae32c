#include "gltf/decode_draco.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <new>
#include <string>

#include <draco/attributes/point_attribute.h>
#include <draco/compression/config/compression_shared.h>
#include <draco/compression/decode.h>
#include <draco/core/decoder_buffer.h>
#include <draco/core/varint_decoding.h>
#include <draco/mesh/mesh.h>
#include <draco/metadata/geometry_metadata.h>
#include <draco/metadata/metadata_decoder.h>

#include "gltf/bad_input.h"

namespace ribalta::gltf {
namespace {

// As DRACO_BITSTREAM_VERSION(2, 2) has it.
constexpr std::uint16_t kBitstreamVersion = 0x0202;

const char* const kExportAgain = "; export the mesh again";

// How much a bitstream claims to hold (Draco bitstream specification 2.2, sections 2, 4, 8). The
// decoder takes memory for it before it has seen it.
struct Claim {
    std::uint64_t faces = 0;
    std::uint64_t vertices = 0;
};

Claim claimOf(std::span<const std::byte> bytes, const Place& place) {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    char magic[5] = {};
    std::uint8_t header[4] = {};
    std::uint16_t flags = 0;
    if (!buffer.Decode(magic, sizeof(magic)) || std::memcmp(magic, "DRACO", 5) != 0 ||
        !buffer.Decode(header, sizeof(header)) || !buffer.Decode(&flags)) {
        badInput(place, std::string("is no Draco data") + kExportAgain);
    }
    const auto& [major, minor, type, method] = header;
    if (major != 2 || minor != 2) {
        badInput(place, "is Draco data of version " + std::to_string(major) + "." +
                            std::to_string(minor) + ", expected 2.2" + kExportAgain);
    }
    if (type != draco::TRIANGULAR_MESH) {
        badInput(place, std::string("is Draco data without triangles") + kExportAgain);
    }
    buffer.set_bitstream_version(kBitstreamVersion);
    if ((flags & METADATA_FLAG_MASK) != 0) {
        draco::GeometryMetadata metadata;
        if (!draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata)) {
            badInput(place, std::string("is Draco data with broken metadata") + kExportAgain);
        }
    }
    std::uint8_t traversal = 0;
    std::uint32_t vertices = 0;
    std::uint32_t faces = 0;
    const bool isEdgebreaker = method == draco::MESH_EDGEBREAKER_ENCODING;
    const bool read =
        isEdgebreaker
            ? buffer.Decode(&traversal) && draco::DecodeVarint(&vertices, &buffer) &&
                  draco::DecodeVarint(&faces, &buffer)
            : draco::DecodeVarint(&faces, &buffer) && draco::DecodeVarint(&vertices, &buffer);
    if (!read) {
        badInput(place, std::string("is truncated Draco data") + kExportAgain);
    }
    return {faces, vertices};
}

std::unique_ptr<draco::Mesh> decodeMesh(std::span<const std::byte> bytes, const Place& place) {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    try {
        auto decoded = draco::Decoder().DecodeMeshFromBuffer(&buffer);
        if (!decoded.ok()) {
            badInput(place, "is broken Draco data (" + std::string(decoded.status().error_msg()) +
                                ")" + kExportAgain);
        }
        return std::move(decoded).value();
    } catch (const std::bad_alloc&) {
        badInput(place, std::string("is Draco data that asks for more memory than there is") +
                            kExportAgain);
    } catch (const std::length_error&) {
        badInput(place, std::string("is Draco data with an impossible size") + kExportAgain);
    }
}

template <typename T>
float loadAs(const std::byte* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return float(value);
}

float loadComponent(const std::byte* bytes, draco::DataType type, bool normalized) {
    switch (type) {
        case draco::DT_INT8:
            return normalized ? std::max(loadAs<std::int8_t>(bytes) / 127.0F, -1.0F)
                              : loadAs<std::int8_t>(bytes);
        case draco::DT_UINT8:
            return loadAs<std::uint8_t>(bytes) / (normalized ? 255.0F : 1.0F);
        case draco::DT_INT16:
            return normalized ? std::max(loadAs<std::int16_t>(bytes) / 32767.0F, -1.0F)
                              : loadAs<std::int16_t>(bytes);
        case draco::DT_UINT16:
            return loadAs<std::uint16_t>(bytes) / (normalized ? 65535.0F : 1.0F);
        case draco::DT_INT32:
            return loadAs<std::int32_t>(bytes);
        case draco::DT_UINT32:
            return loadAs<std::uint32_t>(bytes);
        default:
            return loadAs<float>(bytes);
    }
}

bool isReadable(draco::DataType type) {
    return type == draco::DT_FLOAT32 || (type >= draco::DT_INT8 && type <= draco::DT_UINT32);
}

DracoAttribute readAttribute(const draco::Mesh& mesh, const DracoRequest& request,
                             const Budget& budget) {
    const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(request.id);
    if (attribute == nullptr) {
        badInput(request.place, "is " + std::to_string(request.id) +
                                    ", an attribute that the Draco data does not have" +
                                    kExportAgain);
    }
    const int components = attribute->num_components();
    const draco::DataType type = attribute->data_type();
    if (components < request.components || components > 4 || !isReadable(type)) {
        badInput(request.place, "names Draco data with " + std::to_string(components) +
                                    " components of type " + std::to_string(int(type)) +
                                    ", expected " + std::to_string(request.components) +
                                    " numbers" + kExportAgain);
    }
    const auto componentBytes = std::size_t(draco::DataTypeLength(type));
    budget.expectMemory(
        std::uint64_t(mesh.num_points()) * std::uint64_t(components) * sizeof(float),
        request.place);
    DracoAttribute result;
    result.components = components;
    result.values.resize(std::size_t(mesh.num_points()) * std::size_t(components));
    for (std::uint32_t point = 0; point < mesh.num_points(); ++point) {
        const draco::AttributeValueIndex value = attribute->mapped_index(draco::PointIndex(point));
        if (value.value() >= attribute->size()) {
            badInput(request.place, std::string("names broken Draco data") + kExportAgain);
        }
        const auto* bytes = reinterpret_cast<const std::byte*>(attribute->GetAddress(value));
        if (type == draco::DT_FLOAT32) {  // as nearly all are
            std::memcpy(&result.values[std::size_t(point) * std::size_t(components)], bytes,
                        std::size_t(components) * sizeof(float));
            continue;
        }
        for (std::size_t c = 0; c < std::size_t(components); ++c) {
            result.values[std::size_t(point) * std::size_t(components) + c] =
                loadComponent(bytes + c * componentBytes, type, request.normalized);
        }
    }
    return result;
}

}  // namespace

DracoMesh decodeDraco(std::span<const std::byte> bytes, std::span<const DracoRequest> requests,
                      std::size_t expectedFaces, const Budget& budget, const Place& place) {
    // Regular meshes take well under a bit a face; garbage claims billions.
    const Claim claim = claimOf(bytes, place);
    // A mesh whose faces share nothing has three vertices a face.
    const std::uint64_t faces = std::max(claim.faces, claim.vertices / 3);
    const std::uint64_t limit = 64 * std::uint64_t(bytes.size()) + 4 * expectedFaces;
    if (faces > limit) {
        badInput(place, "is Draco data that claims " + std::to_string(faces) +
                            " triangles, where the file says " + std::to_string(expectedFaces) +
                            kExportAgain);
    }
    // The connectivity and one attribute, as the decoder holds them and as they leave it.
    constexpr std::uint64_t kBytesPerFace = 100;
    constexpr std::uint64_t kBytesPerVertex = 50;
    budget.expectVertices(3 * claim.faces + claim.vertices, place);
    budget.expectMemory(kBytesPerFace * claim.faces + kBytesPerVertex * claim.vertices, place);
    const std::unique_ptr<draco::Mesh> mesh = decodeMesh(bytes, place);
    DracoMesh result;
    result.vertices = mesh->num_points();
    result.indices.reserve(std::size_t(mesh->num_faces()) * 3);
    for (std::uint32_t f = 0; f < mesh->num_faces(); ++f) {
        for (const draco::PointIndex& point : mesh->face(draco::FaceIndex(f))) {
            if (point.value() >= result.vertices) {
                badInput(place,
                         std::string("is Draco data with an index out of range") + kExportAgain);
            }
            result.indices.push_back(point.value());
        }
    }
    for (const DracoRequest& request : requests) {
        result.attributes.push_back(readAttribute(*mesh, request, budget));
    }
    return result;
}

}  // namespace ribalta::gltf
