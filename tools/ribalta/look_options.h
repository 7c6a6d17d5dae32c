// The option --look: a look from its file, brought to a scene.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "gltf/load_gltf.h"
#include "look/look.h"

namespace CLI {
class App;
}

namespace ribalta {

/// The text of --look. Must outlive the parsing of the command it is added to.
struct LookOptions {
    std::optional<std::string> file;

    void addTo(CLI::App& command);

    /// The look; one that changes nothing where none is given. Throws Error(kBadInput).
    Look read() const;
};

/// Changes the scene's lamps as the look has it, adds the files that it reads to the scene's, and
/// says on stderr which lamps the scene lacks. Throws Error(kBadInput).
void bringLook(const Look& look, LoadedScene& loaded);

}  // namespace ribalta
