#include "gltf/read_container.h"

#include <cstdint>
#include <cstring>
#include <string>

#include "base/bytes.h"
#include "gltf/bad_input.h"

namespace ribalta::gltf {
namespace {

constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinChunk = 0x004E4942;

void splitGlb(std::span<const std::byte> bytes, Container& container, const Place& file) {
    if (bytes.size() < kHeaderBytes + kChunkHeaderBytes) {
        badInput(file, "is a GLB cut off after " + std::to_string(bytes.size()) +
                           " bytes; export or copy it again");
    }
    const std::uint32_t version = littleEndian(bytes, 4, 4);
    if (version != 2) {
        badInput(file, "is a GLB of version " + std::to_string(version) +
                           ", expected 2; export it as glTF 2.0");
    }
    const std::size_t length = littleEndian(bytes, 8, 4);
    if (length > bytes.size()) {
        badInput(file, "is a truncated GLB: its header promises " + std::to_string(length) +
                           " bytes, the file has " + std::to_string(bytes.size()) +
                           "; export or copy it again");
    }
    std::size_t at = kHeaderBytes;
    for (int chunk = 0; at + kChunkHeaderBytes <= length; ++chunk) {
        const std::size_t size = littleEndian(bytes, at, 4);
        const std::uint32_t type = littleEndian(bytes, at + 4, 4);
        at += kChunkHeaderBytes;
        if (size > length - at) {
            badInput(file, "is a damaged GLB: chunk " + std::to_string(chunk) + " has " +
                               std::to_string(size) + " bytes, only " +
                               std::to_string(length - at) + " are left; export or copy it again");
        }
        const std::span<const std::byte> content = bytes.subspan(at, size);
        if (chunk == 0) {
            if (type != kJsonChunk) {
                badInput(file, "is a damaged GLB: its first chunk is not JSON; export it again");
            }
            container.json = textOf(content);
        } else if (type == kBinChunk && !container.bin) {
            container.bin = content;
        }
        at += size;
    }
    if (container.json.empty()) {
        badInput(file, "is a GLB without a JSON chunk; export it again");
    }
}

}  // namespace

Container readContainer(std::span<const std::byte> bytes, const Place& file) {
    Container container;
    const std::string_view text = textOf(bytes);
    if (text.empty()) {
        badInput(file, "is empty; expected a .gltf or .glb file");
    }
    if (text.starts_with("glTF")) {
        splitGlb(bytes, container, file);
        return container;
    }
    container.json = text;
    if (text.starts_with("\xEF\xBB\xBF")) {
        container.json.remove_prefix(3);
    }
    const std::size_t start = container.json.find_first_not_of(" \t\r\n");
    if (start == std::string_view::npos || container.json[start] != '{') {
        const bool isUtf16 = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF") ||
                             (text.size() > 1 && (text[0] == '\0' || text[1] == '\0'));
        badInput(file, isUtf16 ? "is not UTF-8 but looks like UTF-16; save it as UTF-8"
                               : "is not a glTF: neither JSON (.gltf) nor binary glTF (.glb); "
                                 "export the scene as glTF 2.0");
    }
    return container;
}

}  // namespace ribalta::gltf
