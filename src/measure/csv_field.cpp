#include "measure/csv_field.h"

#include <nlohmann/json.hpp>

namespace ribalta {

std::string csvText(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) {
        return text;
    }
    std::string result = "\"";
    for (const char c : text) {
        result += c == '"' ? "\"\"" : std::string(1, c);
    }
    return result + "\"";
}

std::string csvField(const nlohmann::json& value) {
    if (value.is_null()) {
        return "";
    }
    return csvText(value.is_string() ? value.get<std::string>() : value.dump());
}

}  // namespace ribalta
