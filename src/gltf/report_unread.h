// What a file holds that is not drawn, told once a feature and place.
#pragma once

#include "base/report.h"
#include "gltf/import.h"

namespace ribalta::gltf {

/// Reports further texture coordinates and colours, and the extensions that are not understood,
/// wherever they stand.
void reportUnread(const Import& import, Report& report);

}  // namespace ribalta::gltf
