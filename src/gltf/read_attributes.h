// A primitive's vertices and indices as the file has them: from accessors or from Draco data.
// Nothing is made, mended or unrolled here.
#pragma once

#include "base/report.h"
#include "gltf/import.h"
#include "scene/mesh.h"

namespace ribalta::gltf {

/// Fills the primitive's arrays; attributes may still differ in length, hold anything but numbers,
/// and indices may be out of range. Returns the mode (0..6) that the indices are of. `place` is the
/// primitive's. Throws Error(kBadInput).
int readAttributes(const Import& import, const tinygltf::Primitive& source,
                   const nlohmann::json& object, const Place& place, Primitive& target,
                   Report& report);

}  // namespace ribalta::gltf
