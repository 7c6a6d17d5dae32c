#include "base/parse_json.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

namespace ribalta {
namespace {

[[noreturn]] void refuse(const Place& place, const std::string& message) {
    throw Error(ErrorKind::kBadInput, place, message);
}

Place lineOf(std::string_view text, std::size_t offset, const Place& file) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t lineStart = before.rfind('\n');
    const std::size_t column =
        before.size() - (lineStart == std::string_view::npos ? 0 : lineStart + 1);
    return {file.file, "line " + std::to_string(line) + ", column " + std::to_string(column)};
}

// Outside strings only brackets nest; a syntax error elsewhere is found by the parser.
template <typename Visit>
void forEachOutsideStrings(std::string_view text, const Visit& visit) {
    bool inString = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inString) {
            if (c == '\\') {
                ++i;
            } else if (c == '"') {
                inString = false;
            }
        } else if (c == '"') {
            inString = true;
        } else {
            visit(c, i);
        }
    }
}

// How deep a text is nested, and what it takes once it is parsed.
struct Extent {
    std::uint64_t memory = 0;
    std::optional<std::size_t> tooDeep;  ///< where it is first nested deeper than the limit
};

Extent measure(std::string_view text, std::uint64_t maxDepth) {
    constexpr std::uint64_t kValue = 32;      // in an array that has room to grow
    constexpr std::uint64_t kMember = 96;     // a node of a tree, with a key
    constexpr std::uint64_t kContainer = 64;  // what an array or object points to
    Extent extent;
    extent.memory = text.size() + kContainer;
    std::uint64_t depth = 0;
    forEachOutsideStrings(text, [&](char c, std::size_t i) {
        if (c == ',') {
            extent.memory += kValue;
        } else if (c == ':') {
            extent.memory += kMember;
        } else if (c == '{' || c == '[') {
            extent.memory += kContainer;
            if (++depth > maxDepth && !extent.tooDeep) {
                extent.tooDeep = i + 1;
            }
        } else if ((c == '}' || c == ']') && depth > 0) {
            --depth;
        }
    });
    return extent;
}

// The parser's message without its own name and position, which lineOf says better.
std::string parserReason(const nlohmann::json::exception& error) {
    const std::string text = error.what();
    const std::size_t name = text.find("] ");
    const std::size_t start = name == std::string::npos ? 0 : name + 2;
    const std::size_t position = text.find(": ", start);
    return text.substr(position == std::string::npos ? start : position + 2);
}

}  // namespace

std::uint64_t jsonMemory(std::string_view text) {
    return measure(text, 0).memory;
}

nlohmann::json parseJson(std::string_view text, const Place& file, const JsonKind& kind,
                         const JsonLimits& limits) {
    const Extent extent = measure(text, limits.depth);
    if (extent.tooDeep) {
        refuse(lineOf(text, *extent.tooDeep, file), "JSON is nested deeper than " +
                                                        std::to_string(limits.depth) +
                                                        " levels; remove such extras");
    }
    if (extent.memory > limits.memory) {
        refuse(file, "holds JSON that takes " + std::to_string(extent.memory) +
                         " bytes of memory, over the limit of " + std::to_string(limits.memory) +
                         "; leave something out of it");
    }
    const std::string cure = "; " + std::string(kind.cure);
    nlohmann::json json;
    try {
        json = nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error& error) {
        refuse(lineOf(text, error.byte, file), "is not valid JSON: " + parserReason(error) + cure);
    } catch (const nlohmann::json::exception& error) {
        refuse(file, "is not valid JSON: " + parserReason(error) + cure);
    }
    if (!json.is_object()) {
        refuse(file, "holds JSON, but no object; expected " + std::string(kind.what));
    }
    return json;
}

}  // namespace ribalta
