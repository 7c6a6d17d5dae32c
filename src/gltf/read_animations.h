// Animations of nodes, morph targets and what pointers name: their keys, and what they move.
#pragma once

#include <vector>

#include "base/report.h"
#include "gltf/bind_dials.h"
#include "gltf/import.h"
#include "gltf/read_nodes.h"
#include "scene/scene.h"

namespace ribalta::gltf {

/// Fills the scene's animations, one for each of the file's in its order, and its movers; its
/// deformers are there already. Reports what is not played: other properties than those of
/// parsePointer, nodes that are not drawn or have a matrix, weights of what has no morph targets,
/// and data that is broken. Returns what bindDials makes dials of.
std::vector<DialSource> readAnimations(const Import& import, const NodeList& list, Scene& scene,
                                       Report& report);

}  // namespace ribalta::gltf
