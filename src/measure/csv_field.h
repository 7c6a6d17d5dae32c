// Fields of CSV lines (RFC 4180).
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace ribalta {

/// Quoted where it has to be.
std::string csvText(const std::string& text);
/// A number as the JSON writes it, so that the two files agree; null is empty.
std::string csvField(const nlohmann::json& value);

}  // namespace ribalta
