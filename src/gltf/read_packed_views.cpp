#include "gltf/read_packed_views.h"

#include <string>

#include "base/parallel_for.h"
#include "gltf/bad_input.h"
#include "gltf/decode_meshopt.h"
#include "gltf/import.h"
#include "gltf/json_rules.h"
#include "gltf/where.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;
using Is = JsonRule::Is;

constexpr const char* kMeshopt = "EXT_meshopt_compression";

const JsonRule kRules[] = {
    {.key = "buffer", .is = Is::kIndex, .required = true, .into = "buffers"},
    {.key = "byteOffset", .is = Is::kInteger, .low = 0},
    {.key = "byteLength", .is = Is::kInteger, .required = true, .low = 1},
    {.key = "byteStride", .is = Is::kInteger, .required = true, .low = 2, .high = 256},
    {.key = "count", .is = Is::kInteger, .required = true, .low = 1},
    {.key = "mode",
     .is = Is::kString,
     .required = true,
     .words = {"ATTRIBUTES", "TRIANGLES", "INDICES"}},
    {.key = "filter",
     .is = Is::kString,
     .words = {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"}},
};

// The extension's object, with its types and ranges checked.
json checkedObject(const Import& import, std::size_t view, const Place& place) {
    json object = extension(element(import.json, "bufferViews", view), kMeshopt);
    if (!object.is_object()) {
        badInput(place, "is no object; pack the mesh again");
    }
    Report mended;  // these rules throw and mend nothing
    try {
        checkMembers(object, kRules, Where(place), import.json, mended);
    } catch (const JsonFault& fault) {
        badInput(fault.place, fault.message + "; pack the mesh again");
    }
    return object;
}

MeshoptLayout layoutOf(const json& object) {
    using Mode = MeshoptLayout::Mode;
    using Filter = MeshoptLayout::Filter;
    const auto mode = object["mode"].get<std::string>();
    const auto filter = object.value("filter", "NONE");
    MeshoptLayout layout;
    layout.mode = mode == "ATTRIBUTES"  ? Mode::kAttributes
                  : mode == "TRIANGLES" ? Mode::kTriangles
                                        : Mode::kIndices;
    layout.filter = filter == "OCTAHEDRAL"   ? Filter::kOctahedral
                    : filter == "QUATERNION" ? Filter::kQuaternion
                    : filter == "NONE"       ? Filter::kNone
                                             : Filter::kExponential;
    layout.count = object["count"].get<std::size_t>();
    layout.stride = object["byteStride"].get<std::size_t>();
    return layout;
}

std::vector<std::byte> unpack(const Import& import, std::size_t view) {
    const Place viewPlace = import.file.at("bufferViews").at(view);
    const Place place = viewPlace.at("extensions").at(kMeshopt);
    const json object = checkedObject(import, view, place);
    const auto buffer = object["buffer"].get<std::size_t>();
    const std::span<const std::byte> bytes = import.buffers.at(buffer).bytes;
    const auto offset = object.value("byteOffset", std::size_t(0));
    const auto length = object["byteLength"].get<std::size_t>();
    if (offset > bytes.size() || length > bytes.size() - offset) {
        badInput(place, "ends at byte " + std::to_string(offset) + " + " + std::to_string(length) +
                            " of buffer " + std::to_string(buffer) + ", which has " +
                            std::to_string(bytes.size()) + " bytes; export the file again");
    }
    const MeshoptLayout layout = layoutOf(object);
    const std::size_t outer = import.model.bufferViews.at(view).byteStride;
    if (outer != 0 && outer != layout.stride) {
        badInput(place.at("byteStride"), "is " + std::to_string(layout.stride) +
                                             ", the buffer view's own is " + std::to_string(outer) +
                                             "; pack the mesh again");
    }
    // A copy, as copyOfView makes it.
    const std::span<const std::byte> packed = bytes.subspan(offset, length);
    return decodeMeshopt(std::vector<std::byte>(packed.begin(), packed.end()), layout,
                         *import.budget, place);
}

}  // namespace

PackedViews findPackedViews(const json& root) {
    PackedViews packed;
    const json& views = member(root, "bufferViews");
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (!extension(views[i], kMeshopt).is_null()) {
            packed.resize(views.size());
            packed[i] = std::make_unique<PackedView>();
        }
    }
    return packed;
}

std::vector<char> findFallbackBuffers(const json& root) {
    const json& buffers = member(root, "buffers");
    std::vector<char> fallback(buffers.size(), 0);
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        fallback[i] = char(member(extension(buffers[i], kMeshopt), "fallback") == true);
    }
    for (const json& view : member(root, "bufferViews")) {
        const json& packed = extension(view, kMeshopt);
        if (packed.is_null()) {
            fallback[view["buffer"].get<std::size_t>()] = 0;
        } else if (const json& source = member(packed, "buffer");
                   source.is_number_unsigned() && source < buffers.size()) {
            fallback[source.get<std::size_t>()] = 0;
        }
    }
    return fallback;
}

bool isPacked(const Import& import, std::size_t view) {
    return view < import.packed.size() && import.packed[view] != nullptr;
}

namespace {

// With the view locked.
void unpackOnce(const Import& import, std::size_t view) {
    PackedView& packed = *import.packed.at(view);
    if (packed.bytes || packed.fault) {
        return;
    }
    try {
        packed.bytes = std::make_shared<const std::vector<std::byte>>(unpack(import, view));
    } catch (const Error&) {
        packed.fault = std::current_exception();
    }
}

}  // namespace

ViewBytes packedBytes(const Import& import, std::size_t view) {
    PackedView& packed = *import.packed.at(view);
    const std::scoped_lock lock(packed.mutex);
    unpackOnce(import, view);
    if (packed.fault) {
        std::rethrow_exception(packed.fault);
    }
    ViewBytes bytes{*packed.bytes, packed.bytes};
    if (packed.expectedReads > 0 && --packed.expectedReads == 0) {
        packed.bytes.reset();
    }
    return bytes;
}

ExpectedReads::ExpectedReads(const Import& import, const std::vector<std::size_t>& accessors)
    : import_(import) {
    if (import.packed.empty()) {
        return;
    }
    std::vector<std::size_t> views;
    for (const std::size_t accessor : accessors) {
        const int view = import.model.accessors.at(accessor).bufferView;
        if (view >= 0 && isPacked(import, std::size_t(view)) &&
            ++import.packed[std::size_t(view)]->expectedReads == 1) {
            views.push_back(std::size_t(view));
        }
    }
    parallelFor(views.size(), [&](std::size_t i) {
        const std::scoped_lock lock(import.packed[views[i]]->mutex);
        unpackOnce(import, views[i]);
    });
}

ExpectedReads::~ExpectedReads() {
    for (const std::unique_ptr<PackedView>& packed : import_.packed) {
        if (packed && packed->expectedReads > 0) {
            packed->expectedReads = 0;
            packed->bytes.reset();
        }
    }
}

}  // namespace ribalta::gltf
