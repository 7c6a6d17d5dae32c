// Animations of nodes and morph targets: their keys, and which part of which node they move.
#pragma once

#include <cstddef>

#include "base/report.h"
#include "gltf/import.h"
#include "gltf/read_nodes.h"
#include "scene/scene.h"

namespace ribalta::gltf {

/// Most values of keys that are read, of all animations together; the channels beyond are left out.
inline constexpr std::size_t kMaxAnimationValues = std::size_t(1) << 24U;

/// Fills the scene's animations, one for each of the file's in its order, and its movers; its
/// deformers are there already. Reports what is not played: what is no property of a node, nodes
/// that are not drawn or have a matrix, weights of what has no morph targets, and data that is
/// broken.
void readAnimations(const Import& import, const NodeList& list, Scene& scene, Report& report);

}  // namespace ribalta::gltf
