// Target: EXT_meshopt_compression's bitstreams. The first four bytes say what a buffer view would.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "gltf/decode_meshopt.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ribalta;
    using Layout = gltf::MeshoptLayout;
    constexpr std::size_t kHeader = 4;
    if (size < kHeader) {
        return 0;
    }
    constexpr Layout::Mode kModes[] = {Layout::Mode::kAttributes, Layout::Mode::kTriangles,
                                       Layout::Mode::kIndices};
    constexpr Layout::Filter kFilters[] = {Layout::Filter::kNone, Layout::Filter::kOctahedral,
                                           Layout::Filter::kQuaternion,
                                           Layout::Filter::kExponential};
    Layout layout;
    layout.mode = kModes[data[0] % 3];
    layout.filter = kFilters[data[0] / 3 % 4];
    layout.count = 1 + data[1] + std::size_t(256) * data[2];
    layout.stride = 1 + data[3];
    LoadLimits limits;
    limits.memory = 10'000'000;
    gltf::Budget budget(limits);
    try {
        const auto packed = std::as_bytes(std::span(data, size)).subspan(kHeader);
        const auto bytes = gltf::decodeMeshopt(packed, layout, budget, {"file", "/bufferViews/0"});
        if (bytes.size() != layout.count * layout.stride) {
            std::abort();
        }
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::kBadInput) {
            std::abort();
        }
    }
    return 0;
}
