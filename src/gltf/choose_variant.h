// KHR_materials_variants: the materials of one of a file's named variants in place of the default.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/report.h"

namespace ribalta::gltf {

/// Puts the materials that the variant (by name, else counted from 0) has for primitives in their
/// place; without a choice nothing changes. Returns the names of the file's variants. Mappings that
/// cannot be read are reported and left out. Throws Error(kUsage) that lists the variants where the
/// one asked for is not among them.
std::vector<std::string> chooseVariant(nlohmann::json& root,
                                       const std::optional<std::string>& nameOrIndex,
                                       const Place& file, Report& report);

}  // namespace ribalta::gltf
