// Text into JSON: syntax and nesting only; what a kind of file asks of it is its reader's matter.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/error.h"

namespace simdjson::dom {
class element;
}

namespace ribalta {

/// What a text may ask for; more is refused before it is parsed.
struct JsonLimits {
    std::uint64_t depth = 200;             ///< objects and arrays within each other
    std::uint64_t memory = 1'000'000'000;  ///< bytes while it is parsed, some 20 times the text
    /// Called before memory is taken: the bytes that stay taken, and those while it is parsed. May
    /// throw.
    std::function<void(std::uint64_t kept, std::uint64_t peak)> takeMemory{};
};

/// What a text should have been, for its errors.
struct JsonKind {
    std::string_view what;  ///< e.g. "a glTF"
    std::string_view cure;  ///< e.g. "export the file again"
};

/// A way past the tree for elements of an array at a document's top: they are read from what the
/// parser lists. A text that simdjson refuses is parsed otherwise, and all of it is in the tree.
struct JsonShortcut {
    std::string_view array;
    /// Returns by element whether it is read, and becomes value_t::discarded in the tree; those
    /// past the end are not.
    std::function<std::vector<char>(const simdjson::dom::element& document)> read{};
};

/// Throws Error(kBadInput) with line and column where the text is no JSON object, or over the
/// limits.
nlohmann::json parseJson(std::string_view text, const Place& file, const JsonKind& kind,
                         const JsonLimits& limits = {}, const JsonShortcut& shortcut = {});

}  // namespace ribalta
