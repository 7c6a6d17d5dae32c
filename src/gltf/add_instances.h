// EXT_mesh_gpu_instancing: the many places of a node's mesh as nodes of their own.
#pragma once

#include "base/report.h"
#include "gltf/import.h"
#include "gltf/read_nodes.h"

namespace ribalta::gltf {

/// Most instances of a scene: each is a node, of some 300 bytes.
inline constexpr std::size_t kMaxInstances = std::size_t(1) << 20U;

/// Moves the meshes of instanced nodes to new nodes below them, one an instance, at the end of
/// `nodes`; these are none of the file's and have no entry in `gltfNodes`. Whatever moves the node
/// moves them. Where they cannot be read, or would be more than kMaxInstances, the mesh stays at
/// its node, which is reported.
void addInstances(const Import& import, NodeList& list, Report& report);

}  // namespace ribalta::gltf
