// Morph targets of a primitive: the displacements of its positions, normals and tangents.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/report.h"
#include "gltf/import.h"
#include "scene/mesh.h"

namespace ribalta::gltf {

/// The targets of a primitive with so many vertices, one for each of the file's; parts that are
/// broken, or all 0, are empty. `mayTake(count)` is asked before memory for so many displacements
/// is taken. `object` is the primitive's JSON, `place` its place.
std::vector<MorphTarget> readTargets(const Import& import, const nlohmann::json& object,
                                     std::size_t vertices, const Place& place,
                                     const std::function<bool(std::uint64_t)>& mayTake,
                                     Report& report);

}  // namespace ribalta::gltf
