// Text into JSON: syntax and nesting only; what a kind of file asks of it is its reader's matter.
#pragma once

#include <string_view>

#include <nlohmann/json.hpp>

#include "base/error.h"

namespace ribalta {

/// Deepest nesting of objects and arrays that is accepted: what handles JSON recurses.
inline constexpr int kMaxJsonDepth = 200;

/// What a text should have been, for its errors.
struct JsonKind {
    std::string_view what;  ///< e.g. "a glTF"
    std::string_view cure;  ///< e.g. "export the file again"
};

/// Throws Error(kBadInput) with line and column where the text is no JSON object, and where it is
/// nested deeper than kMaxJsonDepth.
nlohmann::json parseJson(std::string_view text, const Place& file, const JsonKind& kind);

}  // namespace ribalta
