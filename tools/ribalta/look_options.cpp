#include "look_options.h"

#include <utility>

#include <CLI/CLI.hpp>

#include "base/log.h"
#include "look/look_file.h"

namespace ribalta {

void LookOptions::addTo(CLI::App& command) {
    command
        .add_option("--look", file,
                    "camera, size, lamps as changed, haze, sky, exposure and quality, as the "
                    "window keeps them; what else is given here goes before it")
        ->type_name("FILE.json");
}

Look LookOptions::read() const {
    return file ? readLook(*file) : Look{};
}

BroughtLook::BroughtLook(Look look, LoadedScene& loaded) : look_(std::move(look)) {
    for (const std::string& lamp : lampsNotThere(look_.lamps, loaded.scene)) {
        logWarning("look: the scene has no lamp '" + oneLine(lamp) +
                   "'; what the look changes of it is left out");
    }
    bring(loaded.scene);
    for (std::filesystem::path& file : lightMaps_.files()) {
        loaded.files.push_back(std::move(file));
    }
}

}  // namespace ribalta
