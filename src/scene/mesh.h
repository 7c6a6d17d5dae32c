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

/// By how much a vertex hangs on a joint.
struct Influence {
    std::uint32_t joint = 0;  ///< into Skin::joints, of whichever skin the mesh is drawn with
    float weight = 0.0F;      ///< 0..1
};

/// A shape that a primitive may take on, as displacements from its own: arrays as long as
/// `positions` or empty, finite.
struct MorphTarget {
    std::vector<glm::vec3> positions;  ///< local metres
    std::vector<glm::vec3> normals;
    std::vector<glm::vec3> tangents;
    Bounds bounds;  ///< of the positions' displacements; empty where there are none
};

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

    // Where the mesh changes shape; see Deformer.
    int influencesPerVertex = 0;        ///< 0: hangs on no joints
    std::vector<Influence> influences;  ///< so many a vertex; a vertex's weights add up to 1
    std::vector<Bounds> jointBounds;    ///< by joint: of the vertices that hang on it
    std::vector<MorphTarget> targets;
    /// The file has none: those of whole triangles, which lie in `positions` three by three.
    bool flatNormals = false;

    // Which need to be in memory but once where they are drawn from: primitives with the same
    // number, other than -1, have equal vertices (all arrays but the indices), or equal indices.
    int sharedVertices = -1;
    int sharedIndices = -1;
};

struct Mesh {
    std::string name;
    std::vector<Primitive> primitives;
};

}  // namespace ribalta
