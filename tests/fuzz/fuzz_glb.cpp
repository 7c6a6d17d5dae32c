// Target: .glb files. What begins as one is taken as it is; anything else is two bytes that say how
// much of the rest is JSON, and becomes a whole container around both parts.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "fuzz/load_bytes.h"

namespace {

void append32(std::vector<std::uint8_t>& bytes, std::size_t value) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
        bytes.push_back(std::uint8_t(value >> shift));
    }
}

void appendChunk(std::vector<std::uint8_t>& bytes, std::size_t type,
                 std::span<const std::uint8_t> content) {
    append32(bytes, content.size());
    append32(bytes, type);
    bytes.insert(bytes.end(), content.begin(), content.end());
}

std::vector<std::uint8_t> containerOf(std::span<const std::uint8_t> parts) {
    const std::size_t asked = parts[0] + 256U * parts[1];
    parts = parts.subspan(2);
    const std::size_t jsonSize = asked < parts.size() ? asked : parts.size();
    std::vector<std::uint8_t> bytes = {'g', 'l', 'T', 'F'};
    append32(bytes, 2);
    append32(bytes, 28 + parts.size());
    appendChunk(bytes, 0x4E4F534A, parts.first(jsonSize));
    appendChunk(bytes, 0x004E4942, parts.subspan(jsonSize));
    return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    if (text.starts_with("glTF") || size < 2) {
        ribalta::fuzz::loadBytes({data, size}, ".glb");
    } else {
        ribalta::fuzz::loadBytes(containerOf({data, size}), ".glb");
    }
    return 0;
}
