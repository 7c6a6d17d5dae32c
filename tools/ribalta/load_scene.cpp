#include "load_scene.h"

#include "base/log.h"
#include "base/progress.h"

namespace ribalta {
namespace {

void tellOfScene(const LoadedScene& loaded) {
    for (const Report::Entry& entry : loaded.report.entries()) {
        const std::string line =
            std::string(name(entry.kind)) + ": " + entry.place.text() + ": " + entry.message;
        // What is mended changes the picture and is always said; the rest is for --verbose, and
        // for `ribalta inspect`.
        if (entry.kind == Report::Kind::kRepaired) {
            logWarning(line);
        } else {
            logVerbose(line);
        }
    }
    const Scene& scene = loaded.scene;
    if (scene.spotLights.empty() && scene.pointLights.empty() && scene.directionalLights.empty() &&
        !scene.environment) {
        logWarning("the scene has no lamps; only ambient light is drawn (see --ambient)");
    }
}

LoadedScene load(const std::string& path, const LoadOptions& options) {
    const Progress progress("loading");
    return loadGltf(path, options);
}

}  // namespace

LoadedScene loadScene(const std::string& path, const LoadOptions& options) {
    LoadedScene loaded = load(path, options);
    tellOfScene(loaded);
    return loaded;
}

}  // namespace ribalta
