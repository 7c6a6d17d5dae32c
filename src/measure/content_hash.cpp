#include "measure/content_hash.h"

#include <array>

#include "base/read_file.h"

namespace ribalta {

void ContentHash::add(std::span<const std::byte> bytes) {
    std::uint64_t state = state_;
    for (const std::byte value : bytes) {
        state = (state ^ std::to_integer<std::uint64_t>(value)) * 0x100000001b3;
    }
    state_ = state;
}

void ContentHash::add(std::string_view text) {
    addSize(text.size());
    add(std::as_bytes(std::span(text)));
}

void ContentHash::addSize(std::size_t size) {
    const std::array<std::size_t, 1> one = {size};
    add(std::as_bytes(std::span(one)));
}

std::string ContentHash::text() const {
    constexpr char kDigits[] = "0123456789abcdef";
    std::string text;
    for (int shift = 60; shift >= 0; shift -= 4) {
        text += kDigits[(state_ >> shift) & 15];
    }
    return text;
}

std::string hashScene(std::span<const std::byte> file, const Scene& scene) {
    ContentHash hash;
    hash.add(file);
    for (const Mesh& mesh : scene.meshes) {
        for (const Primitive& primitive : mesh.primitives) {
            hash.add(primitive.positions);
            hash.add(primitive.normals);
            hash.add(primitive.uv0);
            hash.add(primitive.uv1);
            hash.add(primitive.colors);
            hash.add(primitive.indices);
        }
    }
    for (const Image& image : scene.images) {
        hash.add(image.pixels);
    }
    return hash.text();
}

std::string hashProgram() {
    ContentHash hash;
    hash.add(readFile(std::filesystem::read_symlink("/proc/self/exe")));
    return hash.text();
}

}  // namespace ribalta
