// Target: Draco bitstreams, with requests for the attributes that a glTF may name.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "gltf/decode_draco.h"

namespace {

using namespace ribalta;

void checkMesh(const gltf::DracoMesh& mesh, std::size_t requests) {
    bool kept = mesh.attributes.size() == requests && mesh.indices.size() % 3 == 0;
    for (const std::uint32_t index : mesh.indices) {
        kept = kept && index < mesh.vertices;
    }
    for (const gltf::DracoAttribute& attribute : mesh.attributes) {
        kept = kept && attribute.components >= 1 && attribute.components <= 4 &&
               attribute.values.size() == mesh.vertices * std::size_t(attribute.components);
    }
    if (!kept) {
        std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    LoadLimits limits;
    limits.memory = 100'000'000;
    limits.vertices = 1'000'000;
    const gltf::Budget budget(limits);
    const Place place{"file", "/draco"};
    std::vector<gltf::DracoRequest> requests;
    // The last byte says how many.
    const std::uint32_t count = size == 0 ? 0 : data[size - 1] % 5U;
    for (std::uint32_t id = 0; id < count; ++id) {
        requests.push_back({id, 1 + int(id) % 4, id % 2 == 1, place});
    }
    try {
        const auto bytes = std::as_bytes(std::span(data, size));
        checkMesh(gltf::decodeDraco(bytes, requests, 1000, budget, place), requests.size());
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::kBadInput) {
            std::abort();
        }
    }
    return 0;
}
