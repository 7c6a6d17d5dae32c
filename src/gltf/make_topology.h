// glTF's seven primitive modes (section 3.7.2.1) as the three that are drawn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/mesh.h"

namespace ribalta::gltf {

/// `mode` 0..6: points, lines, loop, strip, triangles, strip, fan.
Topology topologyOf(int mode);

/// How many indices unrollIndices makes of `count`.
std::size_t unrolledCount(int mode, std::size_t count);

/// Indices of a mode as indices of its topology, winding kept. What is left over at the end (a
/// third of a triangle) is dropped.
std::vector<std::uint32_t> unrollIndices(int mode, std::vector<std::uint32_t> indices);

}  // namespace ribalta::gltf
