// Cameras, one for every node that has one.
#pragma once

#include <string>
#include <vector>

#include "base/report.h"
#include "gltf/import.h"
#include "scene/camera.h"

namespace ribalta::gltf {

/// The glTF's camera `index` as seen from a node; the caller names it and sets its node. Values
/// that make no picture are replaced and reported.
Camera readCamera(const Import& import, std::size_t index, Report& report);

}  // namespace ribalta::gltf
