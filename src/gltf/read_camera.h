// Cameras, one for every node that has one.
#pragma once

#include <string>
#include <vector>

#include "base/report.h"
#include "gltf/import.h"
#include "scene/camera.h"

namespace ribalta::gltf {

/// A camera for every node of the scene that has one; `gltfNodes` are the glTF's indices of the
/// scene's nodes. Named by its node, then by itself, then "camera_0"; "stand" where both agree but
/// for the suffix (node stand.020, camera stand) with which Blender tells objects apart. Values
/// that make no picture are replaced and reported.
std::vector<Camera> readCameras(const Import& import, const std::vector<std::size_t>& gltfNodes,
                                Report& report);

}  // namespace ribalta::gltf
