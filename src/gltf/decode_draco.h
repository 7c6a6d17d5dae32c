// Draco bitstreams into plain arrays. The only place that knows Draco.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/error.h"
#include "gltf/budget.h"

namespace ribalta::gltf {

/// One attribute that is wanted from a bitstream.
struct DracoRequest {
    std::uint32_t id = 0;     ///< the unique id that the glTF extension names
    int components = 0;       ///< fewest that are wanted, 1..4
    bool normalized = false;  ///< integers become 0..1 or -1..1, as the accessor says
    Place place;              ///< where the request stands, for errors
};

struct DracoAttribute {
    int components = 0;         ///< at least as many as were wanted
    std::vector<float> values;  ///< vertices * components
};

struct DracoMesh {
    std::size_t vertices = 0;
    std::vector<std::uint32_t> indices;      ///< triangles, in range
    std::vector<DracoAttribute> attributes;  ///< in the order of the requests
};

/// Decodes a triangle mesh of bitstream 2.2. `expectedFaces` is what the glTF says of its size:
/// data that claims far more is refused before memory is taken, and so is what is over the budget.
/// Throws Error(kBadInput).
DracoMesh decodeDraco(std::span<const std::byte> bytes, std::span<const DracoRequest> requests,
                      std::size_t expectedFaces, const Budget& budget, const Place& place);

}  // namespace ribalta::gltf
