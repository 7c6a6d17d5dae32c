#include "look_options.h"

#include <CLI/CLI.hpp>

#include "base/log.h"
#include "look/apply_look.h"
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

void bringLook(const Look& look, LoadedScene& loaded) {
    for (const std::string& lamp : lampsNotThere(look.lamps, loaded.scene)) {
        logWarning("look: the scene has no lamp '" + oneLine(lamp) +
                   "'; what the look changes of it is left out");
    }
    LookLightMaps lightMaps;
    applyLamps(look.lamps, lightMaps, loaded.scene);
    for (std::filesystem::path& file : lightMaps.files()) {
        loaded.files.push_back(std::move(file));
    }
}

}  // namespace ribalta
