// Pieces of HTML that reports of sweeps are made of. Knows no records.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace ribalta {

std::string escaped(const std::string& text);

/// Three digits, but whole numbers in full; an infinity as its sign.
std::string shortNumber(double value);

/// An <img> with the picture in it, which lies in `folder`; empty where there is none.
std::string imageTag(const std::filesystem::path& folder, const std::string& name,
                     const std::string& says);

/// What was measured on, in words.
std::string contextHtml(const nlohmann::json& context);

/// A cell of a table; `kind` is its class, or empty.
std::string cell(const std::string& content, const char* kind = "");
/// The row of headings, each with its column's class.
std::string headings(const std::vector<std::pair<const char*, const char*>>& names);

/// The page with each {{name}} replaced; what is filled in is not looked at again.
std::string filled(std::string_view page, const std::map<std::string, std::string>& contents);

}  // namespace ribalta
