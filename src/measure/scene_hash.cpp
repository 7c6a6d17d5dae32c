#include "measure/scene_hash.h"

#include "base/content_hash.h"
#include "base/read_file.h"

namespace ribalta {

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
            hash.add(primitive.influences);
            for (const MorphTarget& target : primitive.targets) {
                hash.add(target.positions);
                hash.add(target.normals);
            }
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
