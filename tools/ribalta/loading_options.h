// How scene files are loaded, as every command that loads one lets its user say.
#pragma once

#include <optional>
#include <string>

#include "gltf/load_options.h"

namespace CLI {
class App;
}

namespace ribalta {

/// The option --scene. Must outlive the parsing of the command it is added to.
struct LoadingOptions {
    std::optional<std::string> scene;

    void addTo(CLI::App& command);

    /// As given.
    LoadOptions parsed() const;
};

}  // namespace ribalta
