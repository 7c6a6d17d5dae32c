// The parts of a report that are no measurements: page, style, scripts, a plotting library. They
// travel inside the program.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace ribalta {

/// By file name, e.g. "report.css".
const std::map<std::string, std::string_view>& reportFiles();

}  // namespace ribalta
