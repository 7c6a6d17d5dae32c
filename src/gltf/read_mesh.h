// Meshes: attributes, indices and materials of primitives into Scene's form.
#pragma once

#include <vector>

#include "base/report.h"
#include "gltf/import.h"
#include "scene/mesh.h"

namespace ribalta::gltf {

/// Which texture coordinates a material's tangents follow: -1 none, 0, 1. One a material, and one
/// more at the end for primitives without a material.
using TangentUvs = std::vector<int>;

/// What a mesh of the file is drawn with.
struct MeshUse {
    std::size_t mesh = 0;    ///< into the file's meshes
    std::size_t joints = 0;  ///< most of any skin that it is drawn with; 0: unskinned everywhere
    bool isMorphed = false;  ///< its morph targets are asked for
};

/// The meshes of the file listed in `wanted`, in that order, decoded in parallel. Materials are the
/// file's indices. A primitive that cannot be drawn is left out and reported. Throws LimitError.
std::vector<Mesh> readMeshes(const Import& import, const std::vector<MeshUse>& wanted,
                             const TangentUvs& tangentUvs, Report& report);

}  // namespace ribalta::gltf
