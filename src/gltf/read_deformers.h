// Which nodes' meshes change shape: skins, and the weights of morph targets. Not what their
// vertices hang on (read_influences), nor the targets themselves (read_targets).
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/report.h"
#include "gltf/import.h"
#include "gltf/read_nodes.h"
#include "scene/scene.h"

namespace ribalta::gltf {

/// Most joints of all skinned nodes together, a skin counted once for each of its nodes, and most
/// vertices of all deformed nodes together, likewise. Nodes beyond are drawn as if they were not
/// deformed.
inline constexpr std::size_t kMaxPosedJoints = std::size_t(1) << 20U;
inline constexpr std::size_t kMaxDeformedVertices = std::size_t(1) << 25U;
/// Most displacements of all morph targets together, those of normals and tangents included.
inline constexpr std::uint64_t kMaxDisplacements = std::uint64_t(1) << 26U;

/// Fills the scene's skins, those that are in use, and its deformers. A skinned mesh moves from its
/// node, whose place glTF 2.0 ignores, to one of its own at the list's end; joints that the scene
/// lacks are added there too.
void readDeformers(const Import& import, NodeList& list, Scene& scene, Report& report);

}  // namespace ribalta::gltf
