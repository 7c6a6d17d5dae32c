// The JSON of animations: types and indices, before any key is read.
#pragma once

#include <nlohmann/json.hpp>

#include "base/report.h"
#include "gltf/where.h"

namespace ribalta::gltf {

/// Checks the document's animations, which are values on top of the scene: what is faulty costs a
/// channel and never the file. Afterwards every animation is an object or null, its "channels" and
/// "samplers" are arrays, and what is in these is right in type and index, or null.
void mendAnimations(nlohmann::json& root, const Where& rootWhere, Report& report);

}  // namespace ribalta::gltf
