// The options that say what the haze is like, the same for every subcommand that draws it.
#pragma once

#include <optional>
#include <string>

#include "scene/haze.h"

namespace CLI {
class App;
}

namespace ribalta {

/// The texts of --haze, --phase and --K. Must outlive the parsing of the command it is added to.
struct HazeOptions {
    std::string haze = "0.02";
    std::string phase = "gibbons";
    std::optional<double> k;

    void addTo(CLI::App& command);

    /// What they mean. Throws CLI::ValidationError that says what was expected.
    Haze parsed() const;
};

}  // namespace ribalta
