// One model plain, quantised, in meshopt's modes and filters and in Draco: the same geometry within
// the precision that each states. And packed data that is not what it says.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <draco/compression/encode.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include "gltf/decode_meshopt.h"
#include "gltf_file.h"
#include "support/expect_error.h"

namespace ribalta::test {
namespace {

using gltf::decodeMeshopt;
using gltf::MeshoptLayout;
using nlohmann::json;

constexpr const char* kMeshopt = "EXT_meshopt_compression";

// A ring with waves, no two vertices closer than some 0.04 m, within -1.5..1.5.
struct Ring {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> uv;
    std::vector<std::uint32_t> indices;

    Ring() {
        constexpr std::uint32_t kAround = 48;
        constexpr std::uint32_t kAcross = 16;
        for (std::uint32_t i = 0; i < kAround; ++i) {
            for (std::uint32_t k = 0; k < kAcross; ++k) {
                const double a = 2.0 * std::numbers::pi * i / kAround;
                const double b = 2.0 * std::numbers::pi * k / kAcross;
                const double tube = 0.4 + 0.05 * std::sin(5.0 * a);
                const glm::dvec3 out(std::cos(a), 0.0, std::sin(a));
                const glm::dvec3 normal = std::cos(b) * out + glm::dvec3(0.0, std::sin(b), 0.0);
                positions.emplace_back(out + tube * normal);
                normals.emplace_back(normal);
                uv.emplace_back(double(i) / kAround, double(k) / kAcross);
                const auto at = [&](std::uint32_t x, std::uint32_t y) {
                    return (i + x) % kAround * kAcross + (k + y) % kAcross;
                };
                indices.insert(indices.end(),
                               {at(0, 0), at(0, 1), at(1, 0), at(1, 0), at(0, 1), at(1, 1)});
            }
        }
    }
};

// A buffer view with the data packed, and another buffer that stands in for it without data.
int addPacked(GltfFile& file, const std::vector<unsigned char>& data, std::size_t count,
              std::size_t stride, const char* mode, const char* filter) {
    const int view = file.addView(data);
    json& object = file.json["bufferViews"][std::size_t(view)];
    object["extensions"][kMeshopt] = {{"buffer", 0},
                                      {"byteOffset", object["byteOffset"]},
                                      {"byteLength", data.size()},
                                      {"byteStride", stride},
                                      {"count", count},
                                      {"mode", mode},
                                      {"filter", filter}};
    object["buffer"] = 1;
    object["byteOffset"] = 0;
    object["byteLength"] = count * stride;
    if (std::string(mode) == "ATTRIBUTES") {
        object["byteStride"] = stride;
    }
    return view;
}

int packVertices(GltfFile& file, const void* vertices, std::size_t count, std::size_t stride,
                 const char* filter) {
    std::vector<unsigned char> data(meshopt_encodeVertexBufferBound(count, stride));
    data.resize(meshopt_encodeVertexBuffer(data.data(), data.size(), vertices, count, stride));
    return addPacked(file, data, count, stride, "ATTRIBUTES", filter);
}

int packIndices(GltfFile& file, const std::vector<std::uint32_t>& indices, std::size_t vertices,
                std::size_t stride, bool isSequence) {
    std::vector<unsigned char> data(
        std::max(meshopt_encodeIndexBufferBound(indices.size(), vertices),
                 meshopt_encodeIndexSequenceBound(indices.size(), vertices)));
    data.resize(
        isSequence
            ? meshopt_encodeIndexSequence(data.data(), data.size(), indices.data(), indices.size())
            : meshopt_encodeIndexBuffer(data.data(), data.size(), indices.data(), indices.size()));
    return addPacked(file, data, indices.size(), stride, isSequence ? "INDICES" : "TRIANGLES",
                     "NONE");
}

int describe(GltfFile& file, int view, int type, const char* shape, std::size_t count,
             bool normalized = false) {
    json accessor = {
        {"bufferView", view}, {"componentType", type}, {"type", shape}, {"count", count}};
    if (normalized) {
        accessor["normalized"] = true;
    }
    return file.push("accessors", accessor);
}

// The file's buffers: what was added, and one without data.
void finish(GltfFile& file) {
    file.json["buffers"] = json::array(
        {{{"byteLength", file.bytes().size()}, {"uri", "data:;base64," + base64(file.bytes())}},
         {{"byteLength", 1 << 20U}, {"extensions", {{kMeshopt, {{"fallback", true}}}}}}});
    file.json["extensionsUsed"] = {kMeshopt, "KHR_mesh_quantization"};
    file.json["extensionsRequired"] = {kMeshopt, "KHR_mesh_quantization"};
}

template <int N>
std::vector<float> flat(const std::vector<glm::vec<N, float>>& values, int components = N) {
    std::vector<float> numbers;
    for (const auto& value : values) {
        for (int c = 0; c < components; ++c) {
            numbers.push_back(c < N ? value[c] : 0.0F);
        }
    }
    return numbers;
}

struct Precision {
    double metres = 0.0;
    double normal = 0.0;  ///< distance of unit vectors
    double uv = 0.0;
};

// Every vertex is one of the ring's within the precision, and so every triangle one of its.
void expectRing(const LoadedScene& loaded, const Precision& precision) {
    const Ring ring;
    ASSERT_EQ(reportText(loaded), "");
    const Primitive& primitive = onlyPrimitive(loaded);
    const glm::dmat4& world = loaded.scene.nodes.at(0).worldFromLocal;
    ASSERT_EQ(primitive.normals.size(), primitive.positions.size());
    ASSERT_EQ(primitive.uv0.size(), primitive.positions.size());
    std::vector<std::uint32_t> original;
    for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
        const glm::dvec3 place(world * glm::dvec4(primitive.positions[i], 1.0));
        const auto nearest = std::min_element(
            ring.positions.begin(), ring.positions.end(), [&](const auto& a, const auto& b) {
                return glm::distance(glm::dvec3(a), place) < glm::distance(glm::dvec3(b), place);
            });
        const auto vertex = std::size_t(nearest - ring.positions.begin());
        original.push_back(std::uint32_t(vertex));
        ASSERT_LE(glm::distance(glm::dvec3(*nearest), place), precision.metres) << i;
        ASSERT_LE(glm::distance(primitive.normals[i], ring.normals[vertex]), precision.normal) << i;
        ASSERT_LE(glm::distance(primitive.uv0[i], ring.uv[vertex]), precision.uv) << i;
    }
    const auto triangles = [](const std::vector<std::uint32_t>& indices, auto vertexOf) {
        std::vector<std::array<std::uint32_t, 3>> list;
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
            std::array<std::uint32_t, 3> corners = {vertexOf(indices[i]), vertexOf(indices[i + 1]),
                                                    vertexOf(indices[i + 2])};
            std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()),
                        corners.end());
            list.push_back(corners);
        }
        std::sort(list.begin(), list.end());
        return list;
    };
    EXPECT_EQ(triangles(primitive.indices, [&](std::uint32_t i) { return original[i]; }),
              triangles(ring.indices, [](std::uint32_t i) { return i; }));
}

// Float attributes, packed; the indices as asked.
GltfFile packedFile(std::size_t indexBytes, bool isSequence) {
    const Ring ring;
    const std::size_t count = ring.positions.size();
    GltfFile file;
    const auto pack = [&](const std::vector<float>& numbers, const char* shape) {
        return describe(
            file, packVertices(file, numbers.data(), count, 4 * numbers.size() / count, "NONE"),
            kFloat, shape, count);
    };
    const json attributes = {{"POSITION", pack(flat(ring.positions), "VEC3")},
                             {"NORMAL", pack(flat(ring.normals), "VEC3")},
                             {"TEXCOORD_0", pack(flat(ring.uv), "VEC2")}};
    const int indices =
        describe(file, packIndices(file, ring.indices, count, indexBytes, isSequence),
                 indexBytes == 2 ? kUnsignedShort : kUnsignedInt, "SCALAR", ring.indices.size());
    file.addMesh({{"attributes", attributes}, {"indices", indices}});
    finish(file);
    return file;
}

// Positions in 16 bits and a node that undoes their scale, normals in 8, coordinates in 16.
GltfFile quantizedFile(bool isPacked) {
    const Ring ring;
    const std::size_t count = ring.positions.size();
    std::vector<std::int16_t> positions;
    std::vector<std::uint16_t> uv;
    for (std::size_t i = 0; i < count; ++i) {
        for (int c = 0; c < 3; ++c) {
            positions.push_back(std::int16_t(std::lround(ring.positions[i][c] / 1.5 * 32767.0)));
        }
        positions.push_back(0);
        uv.push_back(std::uint16_t(std::lround(ring.uv[i].x * 65535.0)));
        uv.push_back(std::uint16_t(std::lround(ring.uv[i].y * 65535.0)));
    }
    std::vector<std::int8_t> normals(4 * count);
    std::vector<float> withPadding = flat(ring.normals, 4);
    if (isPacked) {
        meshopt_encodeFilterOct(normals.data(), count, 4, 8, withPadding.data());
    } else {
        std::transform(withPadding.begin(), withPadding.end(), normals.begin(),
                       [](float x) { return std::int8_t(std::lround(x * 127.0F)); });
    }
    GltfFile file;
    const auto add = [&](const auto& numbers, std::size_t stride, int type, const char* shape,
                         const char* filter) {
        const int view = isPacked ? packVertices(file, numbers.data(), count, stride, filter)
                                  : file.addView(numbers);
        file.json["bufferViews"][std::size_t(view)]["byteStride"] = stride;
        return describe(file, view, type, shape, count, true);
    };
    const json attributes = {{"POSITION", add(positions, 8, kShort, "VEC3", "NONE")},
                             {"NORMAL", add(normals, 4, kByte, "VEC3", "OCTAHEDRAL")},
                             {"TEXCOORD_0", add(uv, 4, kUnsignedShort, "VEC2", "NONE")}};
    const int indices =
        describe(file, file.addView(ring.indices), kUnsignedInt, "SCALAR", ring.indices.size());
    file.addMesh({{"attributes", attributes}, {"indices", indices}});
    file.json["nodes"][0]["scale"] = {1.5, 1.5, 1.5};
    finish(file);
    return file;
}

// Normals are brought to unit length, which rounds.
constexpr Precision kExact = {.metres = 0.0, .normal = 1e-7, .uv = 0.0};

constexpr Precision kQuantized = {.metres = 0.87 * 1.5 / 32767.0,  // half a step, in three axes
                                  .normal = 0.87 / 127.0,
                                  .uv = 0.71 / 65535.0 + 1e-7};

TEST(PackedMeshTest, MeshoptOfFloatsIsTheModelToTheBit) {
    for (const std::size_t indexBytes : {2U, 4U}) {
        for (const bool isSequence : {false, true}) {
            expectRing(load(packedFile(indexBytes, isSequence)), kExact);
        }
    }
}

TEST(PackedMeshTest, QuantizedIsTheModelWithinHalfAStep) {
    expectRing(load(quantizedFile(false)), kQuantized);
    // Names in extensionsRequired change nothing but what is said.
    GltfFile file = quantizedFile(false);
    file.json.erase("extensionsRequired");
    const LoadedScene loaded = load(file);
    expectLine(loaded, Report::Kind::kHint, "/meshes/0/primitives/0/attributes/NORMAL",
               "read all the same");
    EXPECT_EQ(onlyPrimitive(loaded).positions, onlyPrimitive(load(quantizedFile(false))).positions);
}

TEST(PackedMeshTest, OctahedralNormalsAreTheModelWithinTheirSteps) {
    Precision precision = kQuantized;
    // Two coordinates of eight bits fold a sphere: at most some 2.5 times a step.
    precision.normal = 2.5 / 127.0;
    expectRing(load(quantizedFile(true)), precision);
}

TEST(PackedMeshTest, ExponentialPositionsAreTheModelWithinTheirMantissa) {
    const Ring ring;
    const std::size_t count = ring.positions.size();
    GltfFile file = packedFile(4, false);
    const std::vector<float> numbers = flat(ring.positions);
    std::vector<std::uint32_t> encoded(numbers.size());
    meshopt_encodeFilterExp(encoded.data(), count, 12, 15, numbers.data());
    const int view = packVertices(file, encoded.data(), count, 12, "EXPONENTIAL");
    file.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] =
        describe(file, view, kFloat, "VEC3", count);
    finish(file);
    // 15 bits with the sign share an exponent up to 2: steps of 2^-13, half of one in three axes.
    Precision precision = kExact;
    precision.metres = 0.87 / 8192.0;
    expectRing(load(file), precision);
}

TEST(PackedMeshTest, DracoIsTheModelWithinItsBits) {
    const Ring ring;
    draco::Mesh mesh;
    mesh.set_num_points(std::uint32_t(ring.positions.size()));
    const auto add = [&](draco::GeometryAttribute::Type type, int components, const float* data) {
        draco::GeometryAttribute attribute;
        attribute.Init(type, nullptr, std::uint8_t(components), draco::DT_FLOAT32, false,
                       components * 4, 0);
        const int id = mesh.AddAttribute(attribute, true, std::uint32_t(ring.positions.size()));
        for (std::uint32_t i = 0; i < ring.positions.size(); ++i) {
            mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i),
                                                  data + std::size_t(components) * i);
        }
        return mesh.attribute(id)->unique_id();
    };
    const std::uint32_t position = add(draco::GeometryAttribute::POSITION, 3, &ring.positions[0].x);
    const std::uint32_t normal = add(draco::GeometryAttribute::NORMAL, 3, &ring.normals[0].x);
    const std::uint32_t uv = add(draco::GeometryAttribute::TEX_COORD, 2, &ring.uv[0].x);
    for (std::size_t i = 0; i < ring.indices.size(); i += 3) {
        mesh.AddFace({draco::PointIndex(ring.indices[i]), draco::PointIndex(ring.indices[i + 1]),
                      draco::PointIndex(ring.indices[i + 2])});
    }
    draco::Encoder encoder;
    encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 14);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::NORMAL, 10);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::TEX_COORD, 12);
    draco::EncoderBuffer buffer;
    ASSERT_TRUE(encoder.EncodeMeshToBuffer(mesh, &buffer).ok());

    GltfFile file;
    const std::size_t count = ring.positions.size();
    const auto promise = [&](int type, const char* shape, std::size_t length) {
        return file.push("accessors",
                         {{"componentType", type}, {"type", shape}, {"count", length}});
    };
    json primitive = {{"attributes",
                       {{"POSITION", promise(kFloat, "VEC3", count)},
                        {"NORMAL", promise(kFloat, "VEC3", count)},
                        {"TEXCOORD_0", promise(kFloat, "VEC2", count)}}},
                      {"indices", promise(kUnsignedInt, "SCALAR", ring.indices.size())}};
    file.json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
    primitive["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", file.addViewBytes(buffer.data(), buffer.size())},
        {"attributes", {{"POSITION", position}, {"NORMAL", normal}, {"TEXCOORD_0", uv}}}};
    file.addMesh(primitive);
    // The box's longest side in 2^bits - 1 steps for all axes; normals as octahedra of that.
    expectRing(load(file),
               {.metres = 0.87 * 3.0 / 16383.0, .normal = 2.5 / 511.0, .uv = 0.71 / 4095.0});
}

TEST(PackedMeshTest, PackedRotationsMoveANode) {
    GltfFile file = packedFile(4, false);
    const std::vector<float> turns = {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.6F, 0.0F, 0.8F};
    std::vector<std::int16_t> encoded(8);
    meshopt_encodeFilterQuat(encoded.data(), 2, 8, 16, turns.data());
    const int view = packVertices(file, encoded.data(), 2, 8, "QUATERNION");
    file.json["bufferViews"][std::size_t(view)].erase("byteStride");  // for vertices alone
    const int output = describe(file, view, kShort, "VEC4", 2, true);
    const int input = file.addAccessor(std::vector<float>{0.0F, 1.0F}, "SCALAR", kFloat, 2);
    file.json["animations"] = {
        {{"samplers", {{{"input", input}, {"output", output}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "rotation"}}}}}}}};
    finish(file);
    LoadedScene loaded = load(file);
    EXPECT_EQ(reportText(loaded), "");
    poseScene(loaded.scene, 1.0);
    // A quarter turn and a bit about y: cos(2 acos(0.8)) = 0.28.
    EXPECT_NEAR(loaded.scene.nodes[0].worldFromLocal[0].x, 0.28, 1e-4);
    EXPECT_NEAR(loaded.scene.nodes[0].worldFromLocal[0].z, -0.96, 1e-4);
}

TEST(PackedMeshTest, ReadersOfTheFallbackSeeTheSame) {
    // A fallback buffer that is missing is not looked for, and one that is there not used.
    GltfFile file = packedFile(4, false);
    file.json["buffers"][1]["uri"] = "not_there.bin";
    expectRing(load(file), kExact);
}

TEST(PackedMeshTest, BrokenPackingIsRefusedWithItsPlace) {
    const std::string pointer = "/bufferViews/0/extensions/EXT_meshopt_compression";
    const auto refused = [&](const std::string& key, const json& value, const std::string& at,
                             const std::vector<std::string>& words) {
        SCOPED_TRACE(key + " " + value.dump());
        GltfFile file = packedFile(4, false);
        json& object = file.json["bufferViews"][0]["extensions"][kMeshopt];
        object[key] = value;
        if (key == "byteStride") {
            file.json["bufferViews"][0]["byteStride"] = value;
        }
        expectRefused(file, at, words);
    };
    refused("buffer", 7, pointer + "/buffer", {"7", "2 buffers"});
    refused("byteOffset", 1 << 30U, pointer, {"ends at byte", "buffer 0"});
    refused("byteLength", 1 << 30U, pointer, {"ends at byte", "buffer 0"});
    refused("count", 1 << 30U, pointer + "/count", {"at most"});
    refused("count", 0, pointer + "/count", {"at least 1"});
    refused("mode", "POINTS", pointer + "/mode", {"ATTRIBUTES"});
    refused("filter", "QUATERNION", pointer + "/byteStride", {"12", "8 for the filter"});
    refused("byteStride", 16, pointer, {"broken or incomplete"});
    refused("mode", "TRIANGLES", pointer + "/byteStride", {"2 or 4"});
    refused("byteLength", 100, pointer + "/count", {"at most"});
}

TEST(PackedMeshTest, DataOfEveryLengthIsDecodedOrRefused) {
    const Ring ring;
    std::vector<unsigned char> data(meshopt_encodeVertexBufferBound(ring.positions.size(), 12));
    data.resize(meshopt_encodeVertexBuffer(data.data(), data.size(), ring.positions.data(),
                                           ring.positions.size(), 12));
    const MeshoptLayout layout = {.count = ring.positions.size(), .stride = 12};
    gltf::Budget budget({});
    for (std::size_t length = 1; length < data.size(); length += 7) {
        // A heap block of just that size, so that a sanitizer sees what is read beyond it.
        const std::vector<unsigned char> cut(data.begin(), data.begin() + std::ptrdiff_t(length));
        expectError(ErrorKind::kBadInput, {}, [&] {
            decodeMeshopt(std::as_bytes(std::span(cut)), layout, budget, {"file", ""});
        });
    }
    // Another version of the codec.
    data[0] = 0xA1;
    expectError(ErrorKind::kBadInput, {"version"}, [&] {
        decodeMeshopt(std::as_bytes(std::span(data)), layout, budget, {"file", ""});
    });
}

}  // namespace
}  // namespace ribalta::test
