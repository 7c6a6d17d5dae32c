// How far animations may take a scene's nodes, before any of it is played.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "scene/scene.h"

namespace ribalta::gltf {

/// The first node whose place or size could leave what is drawn with (kMaxTransform) at some time,
/// by an upper bound over all keys of all animations; none where every pose is fine. `nodes` are
/// the scene's, at rest.
std::optional<std::size_t> movesOutOfBounds(const Scene& scene, const std::vector<Node>& nodes);

}  // namespace ribalta::gltf
