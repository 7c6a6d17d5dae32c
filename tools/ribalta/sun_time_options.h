// The options that say by time and place where the sun stands.
#pragma once

#include <optional>
#include <string>

#include "sky/sun_position.h"

namespace CLI {
class App;
}

namespace ribalta {

/// The texts of --sun-time, --latitude and --longitude. Must outlive the parsing of the command it
/// is added to.
struct SunTimeOptions {
    std::optional<std::string> time;
    std::optional<std::string> latitude;
    std::optional<std::string> longitude;

    void addTo(CLI::App& command);

    /// The first that is given, "" where none is.
    std::string given() const;
    /// What they mean; none: none is given. Throws CLI::ValidationError that says what was
    /// expected.
    std::optional<SunInSky> parsed() const;
};

}  // namespace ribalta
