#include "gltf/read_buffers.h"

#include <cstdint>
#include <string>

#include "gltf/bad_input.h"
#include "gltf/find_artists_file.h"
#include "gltf/read_packed_views.h"
#include "gltf/read_uri.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

MappedFile mapBufferFile(const Import& import, const std::string& uri, std::uint64_t length,
                         const Place& place, Report& report) {
    const std::filesystem::path path =
        findUri(uri, import.folder, import.allowOutside, place, report);
    try {
        return MappedFile(path, import.budget->memoryLeft(), length);
    } catch (const Error& error) {
        badInput(place, "buffer cannot be read: " + std::string(error.what()));
    }
}

Buffer readBuffer(const Import& import, std::size_t index,
                  std::optional<std::span<const std::byte>> bin, Report& report) {
    const json& buffer = element(import.json, "buffers", index);
    const Place place = import.file.at("buffers").at(index);
    const auto length = buffer["byteLength"].get<std::uint64_t>();
    Buffer result;
    const json& uri = member(buffer, "uri");
    if (uri.is_string()) {
        const auto& text = uri.get_ref<const std::string&>();
        if (isDataUri(text)) {
            import.budget->expectMemory(text.size(), place.at("uri"));
            result.decoded = decodeDataUri(text, place.at("uri"));
            result.bytes = result.decoded;
        } else {
            result.file = mapBufferFile(import, text, length, place.at("uri"), report);
            result.bytes = result.file->bytes();
        }
        import.budget->takeMemory(result.bytes.size(), place);
    } else if (bin) {
        result.bytes = *bin;
    } else {
        return result;
    }
    if (result.bytes.size() < length) {
        badInput(place, "has " + std::to_string(result.bytes.size()) +
                            " bytes, its byteLength is " + std::to_string(length) +
                            "; export or copy the file again");
    }
    result.bytes = result.bytes.first(length);
    return result;
}

}  // namespace

std::vector<Buffer> readBuffers(const Import& import, std::optional<std::span<const std::byte>> bin,
                                Report& report) {
    const std::size_t count = member(import.json, "buffers").size();
    std::vector<Buffer> buffers;
    buffers.reserve(count);
    const std::vector<char> fallback = findFallbackBuffers(import.json);
    for (std::size_t i = 0; i < count; ++i) {
        if (fallback[i] != 0) {
            buffers.emplace_back();
            continue;
        }
        buffers.push_back(readBuffer(import, i, i == 0 ? bin : std::nullopt, report));
    }
    return buffers;
}

ViewBytes viewBytes(const Import& import, std::size_t bufferView) {
    if (isPacked(import, bufferView)) {
        return packedBytes(import, bufferView);
    }
    const tinygltf::BufferView& view = import.model.bufferViews.at(bufferView);
    const std::span<const std::byte> bytes = import.buffers.at(std::size_t(view.buffer)).bytes;
    const Place place = import.file.at("bufferViews").at(bufferView);
    if (bytes.empty()) {
        badInput(place, "lies in buffer " + std::to_string(view.buffer) +
                            ", for which the file has no data");
    }
    if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset) {
        badInput(place, "ends at byte " + std::to_string(view.byteOffset) + " + " +
                            std::to_string(view.byteLength) + " of a buffer of " +
                            std::to_string(bytes.size()) + " bytes; export the file again");
    }
    return {bytes.subspan(view.byteOffset, view.byteLength)};
}

std::vector<std::byte> copyOfView(const Import& import, std::size_t bufferView) {
    const ViewBytes bytes = viewBytes(import, bufferView);
    return {bytes.begin(), bytes.end()};
}

}  // namespace ribalta::gltf
