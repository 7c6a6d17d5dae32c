#include "gltf/decode_meshopt.h"

#include <string>

#include <meshoptimizer.h>

#include "gltf/bad_input.h"

namespace ribalta::gltf {
namespace {

constexpr const char* kPackAgain = "; pack the mesh again or export it without compression";

using Mode = MeshoptLayout::Mode;
using Filter = MeshoptLayout::Filter;

// The library asserts these, which a release build of it leaves out.
void checkStride(const MeshoptLayout& layout, const Place& place) {
    const std::size_t stride = layout.stride;
    const auto refuseUnless = [&](bool isAllowed, const char* allowed) {
        if (!isAllowed) {
            badInput(place.at("byteStride"),
                     "is " + std::to_string(stride) + ", expected " + allowed + kPackAgain);
        }
    };
    if (layout.mode != Mode::kAttributes) {
        refuseUnless(stride == 2 || stride == 4, "2 or 4 for indices");
        if (layout.filter != Filter::kNone) {
            badInput(place.at("filter"),
                     std::string("is for attributes and stands at indices") + kPackAgain);
        }
        return;
    }
    refuseUnless(stride > 0 && stride <= 256 && stride % 4 == 0, "a multiple of 4 up to 256");
    if (layout.filter == Filter::kOctahedral) {
        refuseUnless(stride == 4 || stride == 8, "4 or 8 for the filter OCTAHEDRAL");
    } else if (layout.filter == Filter::kQuaternion) {
        refuseUnless(stride == 8, "8 for the filter QUATERNION");
    }
}

// Fewest bytes that hold so much. Attributes: blocks of at most 256 elements, and of each of their
// bytes two bits a group of 16 elements. Triangles and indices: a byte each, and a header.
void checkCount(std::size_t bytes, const MeshoptLayout& layout, const Place& place) {
    const Place here = place.at("count");
    if (layout.mode == Mode::kTriangles && layout.count % 3 != 0) {
        badInput(here, "is " + std::to_string(layout.count) +
                           ", expected a multiple of 3 for triangles" + kPackAgain);
    }
    const std::size_t most = layout.mode == Mode::kAttributes  ? 64 * bytes / layout.stride
                             : layout.mode == Mode::kTriangles ? 3 * bytes
                                                               : bytes;
    if (layout.count > most) {
        badInput(here, "is " + std::to_string(layout.count) + ", but " + std::to_string(bytes) +
                           " bytes hold at most " + std::to_string(most) + " elements" +
                           kPackAgain);
    }
}

void applyFilter(std::vector<std::byte>& bytes, const MeshoptLayout& layout) {
    switch (layout.filter) {
        case Filter::kNone:
            break;
        case Filter::kOctahedral:
            meshopt_decodeFilterOct(bytes.data(), layout.count, layout.stride);
            break;
        case Filter::kQuaternion:
            meshopt_decodeFilterQuat(bytes.data(), layout.count, layout.stride);
            break;
        case Filter::kExponential:
            meshopt_decodeFilterExp(bytes.data(), layout.count, layout.stride);
            break;
    }
}

}  // namespace

std::vector<std::byte> decodeMeshopt(std::span<const std::byte> data, const MeshoptLayout& layout,
                                     Budget& budget, const Place& place) {
    checkStride(layout, place);
    checkCount(data.size(), layout, place);
    budget.takeMemory(std::uint64_t(layout.count) * layout.stride, place);
    std::vector<std::byte> bytes(layout.count * layout.stride);
    const auto* source = reinterpret_cast<const unsigned char*>(data.data());
    const int fault = layout.mode == Mode::kAttributes
                          ? meshopt_decodeVertexBuffer(bytes.data(), layout.count, layout.stride,
                                                       source, data.size())
                      : layout.mode == Mode::kTriangles
                          ? meshopt_decodeIndexBuffer(bytes.data(), layout.count, layout.stride,
                                                      source, data.size())
                          : meshopt_decodeIndexSequence(bytes.data(), layout.count, layout.stride,
                                                        source, data.size());
    if (fault != 0) {
        badInput(place, std::string(fault == -1 ? "holds data of a kind or version that "
                                                  "EXT_meshopt_compression does not have"
                                                : "holds broken or incomplete data") +
                            kPackAgain);
    }
    applyFilter(bytes, layout);
    return bytes;
}

}  // namespace ribalta::gltf
