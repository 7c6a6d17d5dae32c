// A scene from its file, and what people are told about that.
#pragma once

#include <string>

#include "gltf/load_gltf.h"

namespace ribalta {

/// Loads a glTF file; warns of what was mended and of a scene without lamps, tells the rest of the
/// report with --verbose. Throws as loadGltf.
LoadedScene loadScene(const std::string& path, const LoadOptions& options);

}  // namespace ribalta
