// The options that say how beams are drawn.
#pragma once

#include <optional>
#include <string>

#include "measure/choose_beams.h"
#include "render/frame_settings.h"

namespace CLI {
class App;
}

namespace ribalta {

/// The texts of --beams and what belongs to it. Must outlive the parsing of the command it is added
/// to.
struct BeamOptions {
    std::optional<std::string> method;  ///< "auto" or a method's name
    std::optional<int> planes;
    std::optional<double> tolerance;
    std::string cells;
    std::optional<double> spacingMetres;
    bool eightBit = false;
    std::string budget;
    std::string error;

    void addTo(CLI::App& command);

    /// What they mean, but for `auto`, which stands for the default until it is chosen; `otherwise`
    /// where they are not given. A method that is given starts from its own defaults. Throws
    /// CLI::ValidationError that says what was expected.
    BeamSettings parsed(const BeamSettings& otherwise = {}) const;

    /// What `auto` is to reach; none without `auto`. Throws likewise.
    std::optional<BeamGoal> goal() const;
};

}  // namespace ribalta
