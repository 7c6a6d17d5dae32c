#include "base/parse_json.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

#include <simdjson.h>

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

// How deep a text is nested, and what it takes.
struct Extent {
    std::uint64_t kept = 0;              ///< bytes, once it is parsed
    std::uint64_t peak = 0;              ///< bytes, meanwhile
    std::optional<std::size_t> tooDeep;  ///< where it is first nested deeper than the limit
};

Extent measure(std::string_view text, std::uint64_t maxDepth) {
    Extent extent;
    std::uint64_t commas = 0;
    std::uint64_t colons = 0;
    std::uint64_t containers = 0;
    std::uint64_t depth = 0;
    forEachOutsideStrings(text, [&](char c, std::size_t i) {
        if (c == ',') {
            ++commas;
        } else if (c == ':') {
            ++colons;
        } else if (c == '{' || c == '[') {
            ++containers;
            if (++depth > maxDepth && !extent.tooDeep) {
                extent.tooDeep = i + 1;
            }
        } else if ((c == '}' || c == ']') && depth > 0) {
            --depth;
        }
    });
    constexpr std::uint64_t kValue = 32;      // in an array that has room to grow
    constexpr std::uint64_t kMember = 96;     // a node of a tree, with a key
    constexpr std::uint64_t kContainer = 64;  // what an array or object points to
    constexpr std::uint64_t kListed = 24;     // where one stands, and its value, for a while
    extent.kept = text.size() + kValue * commas + kMember * colons + kContainer * (containers + 1);
    // The parser has a copy of the text and one of its strings.
    extent.peak = extent.kept + 2 * text.size() + kListed * (commas + colons + containers + 1);
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

// Nested at most as deep as the limit, so recursion is.
nlohmann::json treeOf(const simdjson::dom::element& element) {
    namespace dom = simdjson::dom;
    switch (element.type()) {
        case dom::element_type::OBJECT: {
            nlohmann::json::object_t members;
            for (const auto& [key, value] : dom::object(element)) {
                members.insert_or_assign(members.end(), std::string(key), treeOf(value));
            }
            return members;
        }
        case dom::element_type::ARRAY: {
            const dom::array array(element);
            nlohmann::json::array_t elements;
            elements.reserve(array.size());
            for (const dom::element& each : array) {
                elements.push_back(treeOf(each));
            }
            return elements;
        }
        case dom::element_type::STRING:
            return std::string_view(element);
        case dom::element_type::INT64: {
            const std::int64_t number(element);
            return number < 0 ? nlohmann::json(number) : nlohmann::json(std::uint64_t(number));
        }
        case dom::element_type::UINT64:
            return std::uint64_t(element);
        case dom::element_type::DOUBLE:
            return double(element);
        case dom::element_type::BOOL:
            return bool(element);
        case dom::element_type::NULL_VALUE:
            break;
    }
    return nullptr;
}

// The tree of an object without some members.
nlohmann::json treeWithout(std::span<const std::string_view> left,
                           const simdjson::dom::object& object) {
    nlohmann::json::object_t members;
    for (const auto& [key, value] : object) {
        if (std::find(left.begin(), left.end(), key) == left.end()) {
            members.insert_or_assign(members.end(), std::string(key), treeOf(value));
        }
    }
    return members;
}

// The tree of a shortcut's array; the shares are those of its elements, or there are none.
nlohmann::json treeOf(const simdjson::dom::element& list, const JsonShortcut& shortcut,
                      const std::vector<JsonShare>& shares) {
    simdjson::dom::array array;
    if (shares.empty() || list.get(array) != simdjson::SUCCESS) {
        return treeOf(list);
    }
    nlohmann::json::array_t elements;
    elements.reserve(shares.size());
    for (const simdjson::dom::element& each : array) {
        switch (shares[elements.size()]) {
            case JsonShare::kAll:
                elements.push_back(treeOf(each));
                break;
            case JsonShare::kOthers:
                elements.push_back(treeWithout(shortcut.members, each));
                break;
            case JsonShare::kNone:
                elements.emplace_back(nlohmann::json::value_t::discarded);
                break;
        }
    }
    return elements;
}

nlohmann::json treeOf(const simdjson::dom::element& root, const JsonShortcut& shortcut) {
    simdjson::dom::object object;
    if (!shortcut.read || root.get(object) != simdjson::SUCCESS) {
        return treeOf(root);
    }
    const std::vector<JsonShare> shares = shortcut.read(root);
    nlohmann::json::object_t members;
    for (const auto& [key, value] : object) {
        members.insert_or_assign(
            members.end(), std::string(key),
            key == shortcut.array ? treeOf(value, shortcut, shares) : treeOf(value));
    }
    return members;
}

// What nlohmann::json::parse() makes of a text, in half of its time; none where the text is wrong,
// or has what simdjson alone refuses: integers of more than 64 bits, a byte order mark.
std::optional<nlohmann::json> parseFast(std::string_view text, const JsonShortcut& shortcut) {
    simdjson::dom::parser parser;
    simdjson::dom::element root;
    // Of an empty text simdjson copies nothing from nowhere, which is undefined.
    if (text.empty() || parser.parse(text.data(), text.size()).get(root) != simdjson::SUCCESS) {
        return std::nullopt;
    }
    return treeOf(root, shortcut);
}

}  // namespace

nlohmann::json parseJson(std::string_view text, const Place& file, const JsonKind& kind,
                         const JsonLimits& limits, const JsonShortcut& shortcut) {
    const Extent extent = measure(text, limits.depth);
    if (limits.takeMemory) {
        limits.takeMemory(extent.kept, extent.peak);
    }
    if (extent.tooDeep) {
        refuse(lineOf(text, *extent.tooDeep, file), "JSON is nested deeper than " +
                                                        std::to_string(limits.depth) +
                                                        " levels; remove such extras");
    }
    if (extent.peak > limits.memory) {
        refuse(file, "holds JSON that takes " + std::to_string(extent.peak) +
                         " bytes of memory, over the limit of " + std::to_string(limits.memory) +
                         "; leave something out of it");
    }
    const std::string cure = "; " + std::string(kind.cure);
    nlohmann::json json;
    try {
        std::optional<nlohmann::json> fast = parseFast(text, shortcut);
        json = fast ? *std::move(fast) : nlohmann::json::parse(text);
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
