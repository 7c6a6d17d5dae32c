#include "loading_options.h"

#include <CLI/CLI.hpp>

namespace ribalta {

void LoadingOptions::addTo(CLI::App& command) {
    command
        .add_option("--scene", scene,
                    "which of the file's scenes, by name or counted from 0 (default: the one that "
                    "the file names, else its first)")
        ->type_name("NAME|INDEX");
}

LoadOptions LoadingOptions::parsed() const {
    LoadOptions options;
    options.scene = scene;
    return options;
}

}  // namespace ribalta
