// What is drawn, or would be, but breaks a rule of glTF 2.0 or probably is not what was meant.
#pragma once

#include <cstddef>
#include <vector>

#include "base/report.h"
#include "gltf/import.h"
#include "scene/scene.h"

namespace ribalta::gltf {

/// Reports accessors and buffer views that reach past their data and that no drawn mesh uses (drawn
/// ones speak for themselves), misaligned data, and attribute types that need
/// KHR_mesh_quantization. `meshes` are the glTF's indices of the meshes that are drawn.
void reportDataOddities(const Import& import, const std::vector<std::size_t>& meshes,
                        Report& report);

/// Reports textures whose coordinates a primitive lacks, and a scene without anything to draw.
void reportSceneOddities(const Import& import, const std::vector<std::size_t>& meshes,
                         const Scene& scene, Report& report);

}  // namespace ribalta::gltf
