// EXT_meshopt_compression's bitstreams into plain bytes. The only place that knows meshoptimizer;
// it knows no JSON.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/error.h"
#include "gltf/budget.h"

namespace ribalta::gltf {

/// What a packed buffer view says of its data.
struct MeshoptLayout {
    enum class Mode { kAttributes, kTriangles, kIndices };
    enum class Filter { kNone, kOctahedral, kQuaternion, kExponential };

    Mode mode = Mode::kAttributes;
    Filter filter = Filter::kNone;
    std::size_t count = 0;   ///< elements, at least 1
    std::size_t stride = 0;  ///< bytes of one
};

/// The count * stride bytes that were packed. Sizes that the mode or the filter does not allow, and
/// data too short for what it promises, are refused before memory is taken: the result is at most
/// 64 times as long as the data. Throws Error(kBadInput), LimitError.
std::vector<std::byte> decodeMeshopt(std::span<const std::byte> data, const MeshoptLayout& layout,
                                     Budget& budget, const Place& place);

}  // namespace ribalta::gltf
