// What sweeps of all kinds write down of the machine they ran on.
#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "gl/context.h"

namespace ribalta {

/// As Google Benchmark's, with what else a picture's time depends on.
nlohmann::json sweepContext(const Context& context, const std::string& program);

/// Makes it and those above it where they are not there. Throws Error(kJobFailed).
void makeFolder(const std::filesystem::path& folder);

}  // namespace ribalta
