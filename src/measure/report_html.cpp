#include "measure/report_html.h"

#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "base/read_file.h"

namespace ribalta {
namespace {

using Json = nlohmann::json;

std::string base64(const std::vector<std::byte>& bytes) {
    constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        unsigned group = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            group = group << 8 | (j < count ? std::to_integer<unsigned>(bytes[i + j]) : 0U);
        }
        for (std::size_t j = 0; j < 4; ++j) {
            text += j <= count ? kDigits[group >> (18 - 6 * j) & 63] : '=';
        }
    }
    return text;
}

}  // namespace

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

std::string shortNumber(double value) {
    if (std::isinf(value)) {
        return "∞";
    }
    char text[32];
    // Three digits, but whole numbers in full.
    std::snprintf(text, sizeof text, std::abs(value) >= 1000.0 ? "%.0f" : "%.3g", value);
    return text;
}

std::string imageTag(const std::filesystem::path& folder, const std::string& name,
                     const std::string& says) {
    std::error_code ignored;
    if (name.empty() || !std::filesystem::exists(folder / name, ignored)) {
        return "";
    }
    return "<img alt=\"" + escaped(says) + "\" title=\"" + escaped(says) +
           "\" src=\"data:image/png;base64," + base64(readFile(folder / name)) + "\">";
}

std::string contextHtml(const Json& context) {
    constexpr std::pair<const char*, const char*> kShown[] = {
        {"renderer", "renderer"}, {"opengl", "OpenGL"},   {"cpu", "processor"},
        {"num_cpus", "cores"},    {"system", "system"},   {"version", "ribalta"},
        {"date", "date"},         {"command", "command"},
    };
    std::string html = "<dl class=\"context\">\n";
    for (const auto& [name, title] : kShown) {
        if (context.contains(name)) {
            const Json& value = context.at(name);
            html += "<dt>" + std::string(title) + "</dt><dd>" +
                    escaped(value.is_string() ? value.get<std::string>() : value.dump()) +
                    "</dd>\n";
        }
    }
    return html + "</dl>";
}

std::string cell(const std::string& content, const char* kind) {
    return "<td" + (*kind == '\0' ? std::string() : " class=\"" + std::string(kind) + "\"") + ">" +
           content + "</td>";
}

std::string headings(const std::vector<std::pair<const char*, const char*>>& names) {
    std::string html = "<thead><tr>";
    for (const auto& [name, kind] : names) {
        html += "<th" + (*kind == '\0' ? std::string() : " class=\"" + std::string(kind) + "\"") +
                ">" + name + "</th>";
    }
    return html + "</tr></thead>\n";
}

std::string filled(std::string_view page, const std::map<std::string, std::string>& contents) {
    std::string result;
    for (std::size_t at = 0; at < page.size();) {
        const std::size_t mark = page.find("{{", at);
        const std::size_t end = mark == std::string_view::npos ? mark : page.find("}}", mark);
        if (end == std::string_view::npos) {
            return result.append(page.substr(at));
        }
        result.append(page.substr(at, mark - at));
        result.append(contents.at(std::string(page.substr(mark + 2, end - mark - 2))));
        at = end + 2;
    }
    return result;
}

}  // namespace ribalta
