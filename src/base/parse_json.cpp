#include "base/parse_json.h"

#include <algorithm>
#include <cstddef>
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
void checkDepth(std::string_view text, const Place& file) {
    int depth = 0;
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
        } else if (c == '{' || c == '[') {
            if (++depth > kMaxJsonDepth) {
                refuse(lineOf(text, i + 1, file), "JSON is nested deeper than " +
                                                      std::to_string(kMaxJsonDepth) +
                                                      " levels; remove such extras");
            }
        } else if (c == '}' || c == ']') {
            --depth;
        }
    }
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

nlohmann::json parseJson(std::string_view text, const Place& file, const JsonKind& kind) {
    checkDepth(text, file);
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
