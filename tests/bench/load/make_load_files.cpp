// Writes the files that bench_load.py times loading of: large, and of one kind each. No part of the
// program: the script compiles it.
//
// make_load_files FOLDER SCALE      SCALE 1 is full size, 0.01 a hundredth
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include <draco/compression/expert_encode.h>
#include <draco/mesh/mesh.h>
#include <jpeglib.h>
#include <meshoptimizer.h>
#include <png.h>

namespace {

using Bytes = std::string;

struct Vertex {
    float position[3];
    float normal[3];
    float uv[2];
};

struct Grid {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
};

// Rolling hills: neighbouring values are alike, as in a modelled mesh, and no two are equal.
Grid makeGrid(int side, float phase) {
    Grid grid;
    for (int y = 0; y <= side; ++y) {
        for (int x = 0; x <= side; ++x) {
            const float u = float(x) / float(side);
            const float v = float(y) / float(side);
            const float height = 0.3F * std::sin(9.0F * u + phase) * std::cos(7.0F * v - phase);
            const float du = 2.7F * std::cos(9.0F * u + phase) * std::cos(7.0F * v - phase);
            const float dv = -2.1F * std::sin(9.0F * u + phase) * std::sin(7.0F * v - phase);
            const float length = std::sqrt(du * du + dv * dv + 100.0F);
            grid.vertices.push_back({{10.0F * u, height, 10.0F * v},
                                     {-du / length, 10.0F / length, -dv / length},
                                     {u, v}});
        }
    }
    for (std::uint32_t y = 0; y < std::uint32_t(side); ++y) {
        for (std::uint32_t x = 0; x < std::uint32_t(side); ++x) {
            const std::uint32_t a = y * std::uint32_t(side + 1) + x;
            const std::uint32_t b = a + std::uint32_t(side) + 1;
            grid.indices.insert(grid.indices.end(), {a, b, a + 1, a + 1, b, b + 1});
        }
    }
    return grid;
}

// Paint with grain: neither flat, which compresses to nothing, nor noise, which does not compress.
std::vector<std::uint8_t> paint(int side, int seed) {
    std::vector<std::uint8_t> rgb(std::size_t(side) * std::size_t(side) * 3);
    std::uint32_t state = std::uint32_t(seed) * 2654435761U + 1U;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            state = state * 1664525U + 1013904223U;
            const int grain = int(state >> 28U) - 8;
            for (int c = 0; c < 3; ++c) {
                const double wave = std::sin(0.02 * x * (c + 1) + seed) * std::cos(0.03 * y - c);
                const double value = 128.0 + 90.0 * wave + grain;
                rgb[(std::size_t(y) * std::size_t(side) + std::size_t(x)) * 3 + std::size_t(c)] =
                    std::uint8_t(value);
            }
        }
    }
    return rgb;
}

Bytes encodePng(int side, const std::vector<std::uint8_t>& rgb) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = png_uint_32(side);
    image.height = png_uint_32(side);
    image.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    Bytes bytes(size, '\0');
    if (png_image_write_to_memory(&image, bytes.data(), &size, 0, rgb.data(), 0, nullptr) == 0) {
        throw std::runtime_error(image.message);
    }
    bytes.resize(size);
    return bytes;
}

Bytes encodeJpeg(int side, const std::vector<std::uint8_t>& rgb) {
    jpeg_compress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    unsigned char* memory = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&jpeg, &memory, &size);
    jpeg.image_width = JDIMENSION(side);
    jpeg.image_height = JDIMENSION(side);
    jpeg.input_components = 3;
    jpeg.in_color_space = JCS_RGB;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, 90, TRUE);
    jpeg_start_compress(&jpeg, TRUE);
    while (jpeg.next_scanline < jpeg.image_height) {
        auto* row = const_cast<std::uint8_t*>(
            &rgb[std::size_t(jpeg.next_scanline) * std::size_t(side) * 3]);
        jpeg_write_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_compress(&jpeg);
    Bytes bytes(reinterpret_cast<char*>(memory), size);
    jpeg_destroy_compress(&jpeg);
    std::free(memory);
    return bytes;
}

struct DracoData {
    Bytes bytes;
    int position = 0;
    int normal = 0;
    int uv = 0;
};

DracoData encodeDraco(const Grid& grid) {
    draco::Mesh mesh;
    const auto count = draco::PointIndex::ValueType(grid.vertices.size());
    mesh.set_num_points(count);
    const auto add = [&](draco::GeometryAttribute::Type type, int components, std::size_t offset) {
        draco::GeometryAttribute attribute;
        attribute.Init(type, nullptr, std::int8_t(components), draco::DT_FLOAT32, false,
                       std::int64_t(components) * 4, 0);
        const int id = mesh.AddAttribute(attribute, true, count);
        for (draco::PointIndex::ValueType i = 0; i < count; ++i) {
            mesh.attribute(id)->SetAttributeValue(
                draco::AttributeValueIndex(i),
                reinterpret_cast<const char*>(&grid.vertices[i]) + offset);
        }
        return id;
    };
    DracoData data;
    const int position = add(draco::GeometryAttribute::POSITION, 3, offsetof(Vertex, position));
    const int normal = add(draco::GeometryAttribute::NORMAL, 3, offsetof(Vertex, normal));
    const int uv = add(draco::GeometryAttribute::TEX_COORD, 2, offsetof(Vertex, uv));
    for (std::size_t i = 0; i < grid.indices.size(); i += 3) {
        mesh.AddFace({draco::PointIndex(grid.indices[i]), draco::PointIndex(grid.indices[i + 1]),
                      draco::PointIndex(grid.indices[i + 2])});
    }
    data.position = int(mesh.attribute(position)->unique_id());
    data.normal = int(mesh.attribute(normal)->unique_id());
    data.uv = int(mesh.attribute(uv)->unique_id());
    draco::ExpertEncoder encoder(mesh);
    encoder.SetAttributeQuantization(position, 14);
    encoder.SetAttributeQuantization(normal, 10);
    encoder.SetAttributeQuantization(uv, 12);
    encoder.SetSpeedOptions(3, 3);
    draco::EncoderBuffer buffer;
    if (!encoder.EncodeToBuffer(&buffer).ok()) {
        throw std::runtime_error("Draco cannot encode the grid");
    }
    data.bytes.assign(buffer.data(), buffer.size());
    return data;
}

std::string quote(const std::string& text) {
    return "\"" + text + "\"";
}

// A glTF on its way into a GLB.
class File {
  public:
    /// The buffer view's index.
    int view(const void* bytes, std::size_t size, const std::string& more = "") {
        const std::size_t offset = binary_.size();
        binary_.append(static_cast<const char*>(bytes), size);
        binary_.append((4 - binary_.size() % 4) % 4, '\0');
        return add(views_, "{\"buffer\":0,\"byteOffset\":" + std::to_string(offset) +
                               ",\"byteLength\":" + std::to_string(size) + more + "}");
    }
    int rawView(const std::string& object) { return add(views_, object); }
    std::size_t append(const Bytes& bytes) {
        const std::size_t offset = binary_.size();
        binary_ += bytes;
        binary_.append((4 - binary_.size() % 4) % 4, '\0');
        return offset;
    }
    int accessor(int view, std::size_t offset, int componentType, std::size_t count,
                 const char* type, const std::string& more = "") {
        std::string object = view < 0 ? "{"
                                      : "{\"bufferView\":" + std::to_string(view) +
                                            ",\"byteOffset\":" + std::to_string(offset) + ",";
        object += "\"componentType\":" + std::to_string(componentType) +
                  ",\"count\":" + std::to_string(count) + ",\"type\":" + quote(type) + more + "}";
        return add(accessors_, object);
    }
    int mesh(const std::string& primitive) {
        return add(meshes_, "{\"primitives\":[" + primitive + "]}");
    }
    void node(const std::string& object) { add(nodes_, object); }
    void image(int view, const char* type) {
        const int image = add(images_, "{\"bufferView\":" + std::to_string(view) +
                                           ",\"mimeType\":" + quote(type) + "}");
        const int texture = add(textures_, "{\"source\":" + std::to_string(image) + "}");
        add(materials_, "{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":" +
                            std::to_string(texture) + "}}}");
    }
    void require(const char* extension) { extension_ = extension; }
    void fallbackBuffer(std::size_t bytes) { fallbackBytes_ = bytes; }

    void write(const std::filesystem::path& path) const {
        std::string json = "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[";
        for (int i = 0; i < nodes_.count; ++i) {
            json += (i == 0 ? "" : ",") + std::to_string(i);
        }
        json += "]}]";
        if (!extension_.empty()) {
            json += ",\"extensionsUsed\":[" + quote(extension_) + "],\"extensionsRequired\":[" +
                    quote(extension_) + "]";
        }
        json += ",\"buffers\":[{\"byteLength\":" + std::to_string(binary_.size()) + "}";
        if (fallbackBytes_ > 0) {
            json += ",{\"byteLength\":" + std::to_string(fallbackBytes_) +
                    ",\"extensions\":{\"EXT_meshopt_compression\":{\"fallback\":true}}}";
        }
        json += "]";
        const std::pair<const char*, const List*> lists[] = {
            {"bufferViews", &views_},  {"accessors", &accessors_}, {"meshes", &meshes_},
            {"nodes", &nodes_},        {"images", &images_},       {"textures", &textures_},
            {"materials", &materials_}};
        for (const auto& [name, list] : lists) {
            if (list->count > 0) {
                json += "," + quote(name) + ":[" + list->text + "]";
            }
        }
        json += "}";
        json.append((4 - json.size() % 4) % 4, ' ');
        std::ofstream file(path, std::ios::binary);
        const auto number = [&](std::size_t value) {
            const auto word = std::uint32_t(value);
            file.write(reinterpret_cast<const char*>(&word), 4);
        };
        file << "glTF";
        number(2);
        number(12 + 8 + json.size() + (binary_.empty() ? 0 : 8 + binary_.size()));
        number(json.size());
        file << "JSON" << json;
        if (!binary_.empty()) {
            number(binary_.size());
            file.write("BIN\0", 4);
            file << binary_;
        }
        if (!file.flush()) {
            throw std::runtime_error("cannot write " + path.string());
        }
    }

  private:
    struct List {
        std::string text;
        int count = 0;
    };
    static int add(List& list, const std::string& object) {
        list.text += (list.count == 0 ? "" : ",") + object;
        return list.count++;
    }

    Bytes binary_;
    List views_, accessors_, meshes_, nodes_, images_, textures_, materials_;
    std::string extension_;
    std::size_t fallbackBytes_ = 0;
};

constexpr int kFloat = 5126;
constexpr int kUint32 = 5125;

std::string positionRange() {
    return ",\"min\":[0,-0.4,0],\"max\":[10,0.4,10]";
}

std::string attributes(int position, int normal, int uv) {
    return "\"attributes\":{\"POSITION\":" + std::to_string(position) +
           ",\"NORMAL\":" + std::to_string(normal) + ",\"TEXCOORD_0\":" + std::to_string(uv) + "}";
}

std::string plainPrimitive(File& file, const Grid& grid) {
    const std::size_t count = grid.vertices.size();
    const int vertices =
        file.view(grid.vertices.data(), count * sizeof(Vertex), ",\"byteStride\":32");
    const int indices = file.view(grid.indices.data(), grid.indices.size() * 4);
    const int position = file.accessor(vertices, 0, kFloat, count, "VEC3", positionRange());
    const int normal = file.accessor(vertices, 12, kFloat, count, "VEC3");
    const int uv = file.accessor(vertices, 24, kFloat, count, "VEC2");
    const int index = file.accessor(indices, 0, kUint32, grid.indices.size(), "SCALAR");
    return "{" + attributes(position, normal, uv) + ",\"indices\":" + std::to_string(index);
}

void placeMesh(File& file, int mesh, int i) {
    file.node("{\"name\":\"part_" + std::to_string(i) + "\",\"mesh\":" + std::to_string(mesh) +
              ",\"translation\":[" + std::to_string(i % 100 * 11) + ",0," +
              std::to_string(i / 100 * 11) + "]}");
}

void writeGeometry(const std::filesystem::path& path, int side) {
    File file;
    for (int i = 0; i < 8; ++i) {
        placeMesh(file, file.mesh(plainPrimitive(file, makeGrid(side, float(i))) + "}"), i);
    }
    file.write(path);
}

void writeImages(const std::filesystem::path& path, int count, int side, const char* type,
                 const std::function<Bytes(int, const std::vector<std::uint8_t>&)>& encode) {
    File file;
    const Grid grid = makeGrid(1, 0.0F);
    for (int i = 0; i < count; ++i) {
        const Bytes encoded = encode(side, paint(side, i));
        file.image(file.view(encoded.data(), encoded.size()), type);
        placeMesh(
            file,
            file.mesh(plainPrimitive(file, grid) + ",\"material\":" + std::to_string(i) + "}"), i);
    }
    file.write(path);
}

void writeNodes(const std::filesystem::path& path, int count) {
    File file;
    std::vector<int> meshes;
    for (int i = 0; i < 10; ++i) {
        meshes.push_back(file.mesh(plainPrimitive(file, makeGrid(4, float(i))) + "}"));
    }
    for (int i = 0; i < count; ++i) {
        placeMesh(file, meshes[std::size_t(i) % meshes.size()], i);
    }
    file.write(path);
}

void writeDraco(const std::filesystem::path& path, int side) {
    File file;
    file.require("KHR_draco_mesh_compression");
    for (int i = 0; i < 16; ++i) {
        const Grid grid = makeGrid(side, float(i));
        const DracoData data = encodeDraco(grid);
        const int view = file.view(data.bytes.data(), data.bytes.size());
        const std::size_t count = grid.vertices.size();
        const int position = file.accessor(-1, 0, kFloat, count, "VEC3", positionRange());
        const int normal = file.accessor(-1, 0, kFloat, count, "VEC3");
        const int uv = file.accessor(-1, 0, kFloat, count, "VEC2");
        const int index = file.accessor(-1, 0, kUint32, grid.indices.size(), "SCALAR");
        placeMesh(file,
                  file.mesh("{" + attributes(position, normal, uv) +
                            ",\"indices\":" + std::to_string(index) +
                            ",\"extensions\":{\"KHR_draco_mesh_compression\":{\"bufferView\":" +
                            std::to_string(view) + "," +
                            attributes(data.position, data.normal, data.uv) + "}}}"),
                  i);
    }
    file.write(path);
}

// A view that is packed, and stands at `fallback` in the buffer that stands in for it.
int packedView(File& file, const Bytes& packed, std::size_t count, std::size_t stride,
               const char* mode, std::size_t& fallback) {
    const std::size_t offset = file.append(packed);
    const std::size_t bytes = count * stride;
    const int view = file.rawView(
        "{\"buffer\":1,\"byteOffset\":" + std::to_string(fallback) +
        ",\"byteLength\":" + std::to_string(bytes) +
        (std::strcmp(mode, "ATTRIBUTES") == 0 ? ",\"byteStride\":" + std::to_string(stride) : "") +
        ",\"extensions\":{\"EXT_meshopt_compression\":{\"buffer\":0,\"byteOffset\":" +
        std::to_string(offset) + ",\"byteLength\":" + std::to_string(packed.size()) +
        ",\"byteStride\":" + std::to_string(stride) + ",\"count\":" + std::to_string(count) +
        ",\"mode\":" + quote(mode) + "}}}");
    fallback += bytes;
    return view;
}

void writeMeshopt(const std::filesystem::path& path, int side) {
    File file;
    file.require("EXT_meshopt_compression");
    std::size_t fallback = 0;
    for (int i = 0; i < 16; ++i) {
        Grid grid = makeGrid(side, float(i));
        const std::size_t count = grid.vertices.size();
        meshopt_optimizeVertexCache(grid.indices.data(), grid.indices.data(), grid.indices.size(),
                                    count);
        Bytes vertices(meshopt_encodeVertexBufferBound(count, sizeof(Vertex)), '\0');
        vertices.resize(meshopt_encodeVertexBuffer(
            reinterpret_cast<unsigned char*>(vertices.data()), vertices.size(),
            grid.vertices.data(), count, sizeof(Vertex)));
        Bytes indices(meshopt_encodeIndexBufferBound(grid.indices.size(), count), '\0');
        meshopt_encodeIndexVersion(1);
        indices.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(indices.data()),
                                                 indices.size(), grid.indices.data(),
                                                 grid.indices.size()));
        const int vertexView =
            packedView(file, vertices, count, sizeof(Vertex), "ATTRIBUTES", fallback);
        const int indexView =
            packedView(file, indices, grid.indices.size(), 4, "TRIANGLES", fallback);
        const int position = file.accessor(vertexView, 0, kFloat, count, "VEC3", positionRange());
        const int normal = file.accessor(vertexView, 12, kFloat, count, "VEC3");
        const int uv = file.accessor(vertexView, 24, kFloat, count, "VEC2");
        const int index = file.accessor(indexView, 0, kUint32, grid.indices.size(), "SCALAR");
        placeMesh(file,
                  file.mesh("{" + attributes(position, normal, uv) +
                            ",\"indices\":" + std::to_string(index) + "}"),
                  i);
    }
    file.fallbackBuffer(fallback);
    file.write(path);
}

}  // namespace

int main(int count, char** words) {
    if (count != 3) {
        std::fprintf(stderr, "usage: make_load_files FOLDER SCALE\n");
        return 2;
    }
    const std::filesystem::path folder = words[1];
    const double scale = std::stod(words[2]);
    const auto side = [&](double full) { return std::max(2, int(full * std::sqrt(scale))); };
    try {
        writeGeometry(folder / "geometry.glb", side(354));
        writeImages(folder / "png.glb", 64, side(1024), "image/png", encodePng);
        writeImages(folder / "jpeg.glb", 64, side(1024), "image/jpeg", encodeJpeg);
        writeNodes(folder / "nodes.glb", std::max(1, int(100'000 * scale)));
        writeDraco(folder / "draco.glb", side(180));
        writeMeshopt(folder / "meshopt.glb", side(180));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "make_load_files: %s\n", error.what());
        return 1;
    }
    return 0;
}
