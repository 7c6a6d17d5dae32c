// Target: .gltf files, JSON with data URIs.
#include <cstddef>
#include <cstdint>

#include "fuzz/load_bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ribalta::fuzz::loadBytes({data, size}, ".gltf");
    return 0;
}
