// Values of a KHR_lights_punctual light that no lamp can be drawn with.
#pragma once

#include <nlohmann/json.hpp>

#include "base/report.h"
#include "gltf/where.h"

namespace ribalta::gltf {

/// Brings a light's range and cone into what is drawn (scene/light.h) and reports what it changed.
/// The types in `light` are already right. A spot has a "spot" with both angles afterwards.
void mendLight(nlohmann::json& light, const Where& where, Report& report);

}  // namespace ribalta::gltf
