// Is this JSON a glTF? Types, references and ranges of everything the import reads, in one pass
// before anything is read. Meshes' data, node cycles and extensions are checked elsewhere.
#pragma once

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/report.h"

namespace ribalta::gltf {

/// Afterwards every member the import reads is of the right type, every index is in range, every
/// integer is stored as one, and every factor is in its range. A wrong type or reference in the
/// structure throws Error(kBadInput) with its pointer; one in a mere value (a name, a factor, a
/// sampler setting, a light) is mended in `json` and reported.
void checkJson(nlohmann::json& json, const Place& file, Report& report);

}  // namespace ribalta::gltf
