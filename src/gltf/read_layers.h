// KHR_materials_ior, specular, clearcoat, sheen, anisotropy, transmission and
// pbrSpecularGlossiness into a material's layers.
#pragma once

#include <nlohmann/json.hpp>

#include "base/report.h"
#include "gltf/read_material.h"

namespace ribalta::gltf {

/// Adds to a material what the extensions of its object, which stands at `place`, say; those of an
/// unlit material say nothing. What of them is not drawn is reported.
void readLayers(const nlohmann::json& object, const Place& place, TextureTable& textures,
                Material& material, Report& report);

}  // namespace ribalta::gltf
