// A primitive's vertices and indices as the file has them: from accessors or from Draco data.
// Nothing is made, mended or unrolled here.
#pragma once

#include <vector>

#include "base/report.h"
#include "gltf/import.h"
#include "gltf/read_influences.h"
#include "scene/mesh.h"

namespace ribalta::gltf {

/// Fills the primitive's arrays, and the joint sets where they are asked for; attributes may still
/// differ in length, hold anything but numbers, and indices may be out of range. Returns the mode
/// (0..6) that the indices are of. `place` is the primitive's. Throws Error(kBadInput).
int readAttributes(const Import& import, const tinygltf::Primitive& source,
                   const nlohmann::json& object, const Place& place, Primitive& target,
                   std::vector<JointSet>* joints, Report& report);

}  // namespace ribalta::gltf
