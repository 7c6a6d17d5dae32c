// Text into JSON: syntax and nesting only; what a kind of file asks of it is its reader's matter.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
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

/// What the tree has of an element.
enum class JsonShare : char {
    kAll,
    kOthers,  ///< an object without some members
    kNone,    ///< value_t::discarded
};

/// A way past the tree for elements of an array at a document's top: they are read from what the
/// parser lists. A text that simdjson refuses is parsed otherwise, and all of it is in the tree.
struct JsonShortcut {
    std::string_view array;
    std::span<const std::string_view> members{};  ///< that kOthers leaves out
    /// Returns by element what is not read and left to the tree; nothing at all where all is.
    std::function<std::vector<JsonShare>(const simdjson::dom::element& document)> read{};
};

/// Throws Error(kBadInput) with line and column where the text is no JSON object, or over the
/// limits.
nlohmann::json parseJson(std::string_view text, const Place& file, const JsonKind& kind,
                         const JsonLimits& limits = {}, const JsonShortcut& shortcut = {});

}  // namespace ribalta
