// The option --look: a look from its file, brought to a scene.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "gltf/load_gltf.h"
#include "look/apply_look.h"
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

/// A look's changes of a scene's lamps, to be made anew whenever the scene has been posed.
class BroughtLook {
  public:
    /// Changes the lamps, adds the files that are read for it to the scene's, and says on stderr
    /// which lamps the scene lacks. Throws Error(kBadInput).
    BroughtLook(Look look, LoadedScene& loaded);

    /// Changes the lamps of the same scene again.
    void bring(Scene& scene) { applyLamps(look_.lamps, lightMaps_, scene); }

  private:
    Look look_;
    LookLightMaps lightMaps_;
};

}  // namespace ribalta
