// Meshes: attributes, indices and materials of primitives into Scene's form.
#pragma once

#include <vector>

#include "base/report.h"
#include "gltf/import.h"
#include "scene/mesh.h"

namespace ribalta::gltf {

/// Which texture coordinates a material's normal map uses: -1 none, 0, 1. One a material, and one
/// more at the end for primitives without a material.
using NormalMapUvs = std::vector<int>;

/// The meshes of the file listed in `wanted`, in that order, decoded in parallel. Materials are the
/// file's indices. A primitive that cannot be drawn is left out and reported. Throws LimitError.
std::vector<Mesh> readMeshes(const Import& import, const std::vector<std::size_t>& wanted,
                             const NormalMapUvs& normalMapUvs, Report& report);

}  // namespace ribalta::gltf
