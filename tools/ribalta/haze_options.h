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
    std::optional<std::string> haze;
    std::optional<std::string> phase;
    std::optional<double> k;

    void addTo(CLI::App& command);

    /// What they mean; `otherwise` where they are not given. Throws CLI::ValidationError that says
    /// what was expected.
    Haze parsed(const Haze& otherwise = {}) const;
};

}  // namespace ribalta
