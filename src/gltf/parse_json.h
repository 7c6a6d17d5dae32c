// Text into JSON: syntax and nesting only; what glTF asks of it is check_json's matter.
#pragma once

#include <string_view>

#include <nlohmann/json.hpp>

#include "base/error.h"

namespace ribalta::gltf {

/// Deepest nesting of objects and arrays that is accepted: what handles JSON recurses.
inline constexpr int kMaxJsonDepth = 200;

/// Throws Error(kBadInput) with line and column where the text is no JSON object, and where it is
/// nested deeper than kMaxJsonDepth.
nlohmann::json parseJson(std::string_view text, const Place& file);

}  // namespace ribalta::gltf
