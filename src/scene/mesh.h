// Mesh: geometry as the renderer wants it, whatever encoding the file used.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "scene/bounds.h"

namespace ribalta {

/// What the indices draw. Strips, fans and loops are turned into these on import.
enum class Topology { kPoints, kLines, kTriangles };

/// One draw of one material. Attribute arrays are as long as `positions` or empty.
struct Primitive {
    Topology topology = Topology::kTriangles;
    std::vector<glm::vec3> positions;  ///< local metres, finite
    std::vector<glm::vec3> normals;    ///< unit; empty for points and lines without normals
    std::vector<glm::vec4> tangents;   ///< unit xyz, w = +-1; only where a normal map needs them
    std::vector<glm::vec2> uv0;
    std::vector<glm::vec2> uv1;
    std::vector<glm::vec4> colors;       ///< linear R, G, B, A
    std::vector<std::uint32_t> indices;  ///< into the arrays above; always present, in range
    int material = -1;                   ///< -1: glTF's default material
    Bounds bounds;                       ///< of the positions, local
};

struct Mesh {
    std::string name;
    std::vector<Primitive> primitives;
};

}  // namespace ribalta
