#include "view_command.h"

#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/log.h"
#include "base/temporary_file.h"
#include "cache_options.h"
#include "loading_options.h"
#include "look_options.h"
#include "options.h"
#include "viewer/viewer.h"

namespace ribalta {
namespace {

struct ViewOptions {
    std::string scene;
    LoadingOptions loading;
    LookOptions look;
    std::optional<std::string> size;
    bool noPanels = false;
    std::string pictures;
    std::string shaders;
    std::string stats;
    CacheOptions cache;
    bool verbose = false;
};

void writeViewerStats(const std::filesystem::path& path, const ViewerStats& stats) {
    nlohmann::ordered_json json;
    json["renderer"] = stats.renderer;
    json["first_picture_ms"] = stats.firstPictureMs;
    json["whole_picture_ms"] = stats.wholePictureMs;
    json["load"] = nlohmann::json::array();
    for (const LoadedScene::Stage& stage : stats.load) {
        json["load"].push_back({{"stage", stage.name}, {"ms", stage.ms}});
    }
    json["pictures_drawn"] = stats.picturesDrawn;
    json["pictures_kept"] = stats.picturesKept;
    json["frames_shown"] = stats.framesShown;
    json["scenes_loaded"] = stats.scenesLoaded;
    json["gl_errors"] = stats.glErrors;
    writeFileAtomically(path, json.dump(2) + "\n");
}

void view(const ViewOptions& options) {
    setVerbose(options.verbose);
    ViewerOptions viewer;
    if (!options.scene.empty()) {
        viewer.scene = options.scene;
    }
    const std::optional<FileCache> cache = options.cache.cache();
    viewer.loading = options.loading.parsed();
    viewer.loading.cache = cache ? &*cache : nullptr;
    viewer.look = options.look.read();
    viewer.lookFile = options.look.file.value_or("");
    if (options.size) {
        const PictureSize size = parseSize(*options.size);
        viewer.look.size = glm::ivec2(size.width, size.height);
    }
    viewer.showPanels = !options.noPanels;
    viewer.pictures = options.pictures;
    viewer.shaders = options.shaders;
    viewer.cache = cache;
    const ViewerStats stats = runViewer(std::move(viewer));
    if (!options.stats.empty()) {
        writeViewerStats(options.stats, stats);
    }
}

}  // namespace

void addViewCommand(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("view", "Shows a scene in a window, to explore and light it.");
    const auto options = std::make_shared<ViewOptions>();
    command
        ->add_option("scene", options->scene,
                     "glTF scene, .gltf or .glb; without one, drop it on the window")
        ->type_name("FILE");
    options->loading.addTo(*command);
    options->look.addTo(*command);
    addSizeOption(*command, options->size);
    command->add_flag("--no-panels", options->noPanels,
                      "begin with the picture alone; the key P shows the panels");
    command
        ->add_option("--pictures", options->pictures,
                     "folder for pictures that F12 saves (default: the current one)")
        ->type_name("FOLDER");
    command
        ->add_option("--shaders", options->shaders,
                     "for work on ribalta itself: read the shaders from this folder, and anew "
                     "whenever one of them changes")
        ->type_name("FOLDER")
        ->check(CLI::ExistingDirectory.description(""));
    command
        ->add_option("--stats", options->stats,
                     "when the window closes, write to this JSON file how long the first picture "
                     "took and how many were drawn")
        ->type_name("FILE.json");
    options->cache.addTo(*command);
    command->add_flag("--verbose", options->verbose, "say more on stderr");
    command->callback([options] { view(*options); });
}

}  // namespace ribalta
