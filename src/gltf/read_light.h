// Lamps: KHR_lights_punctual on nodes, and the light maps of their custom properties.
#pragma once

#include <cstddef>

#include "base/report.h"
#include "gltf/import.h"
#include "gltf/read_material.h"
#include "scene/scene.h"

namespace ribalta::gltf {

/// Adds the lamp that hangs on the glTF's node `gltfNode`, if one does, to the scene as hanging on
/// the scene's node `sceneNode`. Light maps are entered into the tables.
void addLamp(const Import& import, std::size_t gltfNode, int sceneNode, ImageTable& images,
             TextureTable& textures, Scene& scene, Report& report);

}  // namespace ribalta::gltf
