// A material's use of a texture: which, by which coordinates (KHR_texture_transform).
#pragma once

#include <optional>

#include <nlohmann/json.hpp>

#include "base/report.h"
#include "gltf/read_material.h"
#include "scene/material.h"

namespace ribalta::gltf {

/// Sets of texture coordinates that are read; a slot that asks for another one is left out.
inline constexpr int kUvSets = 2;

/// The set of coordinates a slot is looked up with: KHR_texture_transform may override it.
int uvSetOf(const nlohmann::json& slot);

/// The slot that `holder`, which stands at `holderPlace`, has under a key; none where it has none
/// or none that can be drawn, which is reported.
std::optional<TextureSlot> readTextureSlot(const nlohmann::json& holder, const char* key,
                                           const Place& holderPlace, TextureTable& textures,
                                           Report& report);

}  // namespace ribalta::gltf
