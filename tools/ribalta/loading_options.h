// How scene files are loaded, as every command that loads one lets its user say.
#pragma once

#include <optional>
#include <string>

#include "gltf/load_options.h"

namespace CLI {
class App;
}

namespace ribalta {

/// The options --scene, --variant, --unit-scale, --intensity-scale, --limits and --allow-outside.
/// Must outlive the parsing of the command it is added to.
struct LoadingOptions {
    std::optional<std::string> scene;
    std::optional<std::string> variant;
    double unitScale = 1.0;
    double intensityScale = 1.0;
    std::optional<std::string> limits;
    bool allowOutside = false;

    void addTo(CLI::App& command);

    /// As given. Throws CLI::ValidationError that says what was expected.
    LoadOptions parsed() const;
};

}  // namespace ribalta
