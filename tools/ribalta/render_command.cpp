#include "render_command.h"

#include <chrono>
#include <cstdio>
#include <memory>
#include <set>
#include <string>

#include <CLI/CLI.hpp>

#include "animation_options.h"
#include "base/error.h"
#include "base/freed_memory.h"
#include "base/log.h"
#include "base/progress.h"
#include "beam_options.h"
#include "cache_options.h"
#include "early_context.h"
#include "frame_files.h"
#include "gl/counters.h"
#include "haze_options.h"
#include "load_scene.h"
#include "loading_options.h"
#include "look_options.h"
#include "options.h"
#include "output_checks.h"
#include "process.h"
#include "render/renderer.h"
#include "render_frames.h"
#include "render_outputs.h"
#include "render_stats.h"
#include "sky_options.h"

namespace ribalta {
namespace {

using Clock = std::chrono::steady_clock;

double msSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

struct RenderOptions {
    std::string scene;
    LoadingOptions loading;
    std::vector<std::filesystem::path> outputs;
    std::optional<std::string> camera;
    LookOptions look;
    std::optional<std::string> size;
    HazeOptions haze;
    SkyOptions sky;
    CacheOptions cache;
    BeamOptions beams;
    AnimationOptions animation;
    std::optional<std::string> exposure;
    std::optional<ToneCurve> toneCurve;
    std::optional<double> ambient;
    std::optional<double> illuminance;
    std::string layers;
    std::string stats;
    int repeat = 1;
    bool redraw = false;
    bool still = false;
    bool verbose = false;
};

// What the options say, and `look` where they say nothing.
FrameSettings settingsFrom(const RenderOptions& options, const Look& look,
                           const RenderOutputs& outputs) {
    FrameSettings settings;
    const PictureSize size = parseSize(
        options.size, look.size ? PictureSize{look.size->x, look.size->y} : PictureSize{});
    settings.width = size.width;
    settings.height = size.height;
    settings.haze = options.haze.parsed(look.haze);
    settings.beams = options.beams.parsed(look.beams);
    settings.ambientLux = options.ambient.value_or(look.ambientLux);
    settings.ev100 = options.exposure ? parseExposure(*options.exposure) : look.ev100;
    settings.toneCurve = options.toneCurve.value_or(look.toneCurve);
    if (settings.beams.eightBitBlending && !settings.ev100) {
        throw CLI::ValidationError("--eight-bit", "needs an exposure: give --exposure EV100");
    }
    if (options.illuminance) {
        settings.illuminance = IlluminanceView{*options.illuminance};
    }
    settings.display = outputs.wantsDisplay();
    settings.beamsOutput = outputs.layers.beams;
    settings.normalOutput = outputs.layers.normal;
    return settings;
}

// Those that lamps project are uploaded again where their number changes.
void letGoOfSurfacePictures(Scene& scene) {
    std::set<int> projected;
    for (const SpotLight& lamp : scene.spotLights) {
        if (lamp.lightMap) {
            projected.insert(lamp.lightMap->image);
        }
    }
    for (std::size_t i = 0; i < scene.images.size(); ++i) {
        if (!projected.contains(int(i))) {
            scene.images[i].pixels = {};
        }
    }
}

RenderStats drawFrames(Renderer& renderer, const Scene& scene, const Camera& camera,
                       const FrameSettings& settings, const RenderOptions& options,
                       const GlCounters& before) {
    RenderStats stats;
    Progress progress("drawing", std::size_t(options.repeat));
    for (int i = 0; i < options.repeat; ++i) {
        if (options.redraw) {
            renderer.forget();
        } else if (!options.still) {
            renderer.redrawNextFrame();
        }
        const Clock::time_point start = Clock::now();
        const FramePlan& plan = renderer.draw(camera, settings);
        FrameTimes times;
        times.passes = renderer.takeTimes();
        times.frameMs = msSince(start);
        stats.frames.push_back(std::move(times));
        stats.shadowMapsDrawn += int(plan.shadowMapWork.size());
        stats.shadowMapsKept += plan.shadowMapsKept;
        stats.meshesDeformed += int(plan.deformWork.size());
        stats.meshesKept += plan.deformersKept;
        stats.verticesDeformed += plan.verticesDeformed;
        if (plan.sunShadow) {
            const int drawn = plan.sunShadow->drawn();
            stats.sunMapsDrawn += drawn;
            stats.sunMapsKept += int(plan.sunShadow->cascades.size()) - drawn;
        }
        if (i == 0) {
            stats.plan = plan.describe();
            stats.firstPixelMs = processMs();
        }
        stats.framesKept += plan.kept ? 1 : 0;
        progress.step();
    }
    countPlan(renderer.lastPlan(), scene, stats);
    stats.drawCalls = glCounters().drawCalls - before.drawCalls;
    stats.programsBuilt = glCounters().programsBuilt - before.programsBuilt;
    stats.texturesMade = glCounters().texturesMade - before.texturesMade;
    stats.ev100 = renderer.ev100();
    return stats;
}

// What `auto` comes to, and says so. Tried with a renderer of its own, so that the picture is drawn
// and counted as if its method had been asked for by name.
BeamSettings chooseAndTell(const Scene& scene, const Camera& camera, const FrameSettings& settings,
                           const BeamGoal& goal) {
    BeamChoice choice;
    {
        const Progress progress("choosing how to draw the beams");
        Renderer trial(scene);
        choice = chooseBeams(trial, camera, settings, goal);
    }
    char took[128];
    std::snprintf(took, sizeof took, "beams: auto took %s with %d sheets: %.3g ms, error %.2g %%",
                  std::string(name(choice.beams.method)).c_str(), choice.beams.planes,
                  choice.beamsMs, choice.errorPercent);
    if (choice.reached) {
        logNote(took);
        return choice.beams;
    }
    char missed[96];
    std::snprintf(missed, sizeof missed,
                  goal.budgetMs ? "; nothing keeps within %.3g ms here, this is the fastest"
                                : "; nothing keeps within %.3g %% here, this is the closest",
                  goal.budgetMs.value_or(goal.errorPercent));
    logWarning(std::string(took) + missed);
    return choice.beams;
}

// How long each part took, and what was drawn with.
void tellOfFrames(const std::string& scene, const RenderStats& stats) {
    logVerbose("plan: " + std::filesystem::path(scene).stem().string() + ": " + stats.plan);
    char line[96];
    for (const LoadedScene::Stage& stage : stats.load) {
        std::snprintf(line, sizeof line, "load: %-10s %9.2f ms", stage.name.c_str(), stage.ms);
        logVerbose(line);
    }
    logVerbose(describeTimes(stats));
    std::snprintf(line, sizeof line, "first pixel: %.0f ms after the program's start",
                  stats.firstPixelMs);
    logVerbose(line);
    if (stats.ev100) {
        std::snprintf(line, sizeof line, "exposure: EV100 %.2f", *stats.ev100);
        logVerbose(line);
    }
}

// What the picture leaves out of the sky's doing.
void tellOfSky(const SkyWork& sky, const Haze& haze) {
    if (haze.scatteringPerMetre > 0.0 && !sky.haze.isEmpty()) {
        logNote("sky: daylight in the haze has no shafts: it meets no shadows on its way");
    }
    warnIfBelowGround(sky.eye);
}

void tellOfPlan(const FramePlan& plan) {
    if (plan.lampsWithoutShadow > 0) {
        logWarning(std::to_string(plan.lampsWithoutShadow) +
                   " lamps cast no shadows: more lamps have casters than there are shadow maps");
    }
    if (plan.sky) {
        tellOfSky(*plan.sky, plan.settings.haze);
    }
}

void render(RenderOptions& options) {
    setVerbose(options.verbose);
    const RenderOutputs outputs{options.outputs, parseLayers(options.layers), options.stats};
    if (outputs.files.empty() && outputs.stats.empty() && !options.verbose) {
        throw CLI::ValidationError("nothing to write",
                                   "give -o FILE.png, -o FILE.exr or --stats FILE.json");
    }
    const Look look = options.look.read();
    options.sky.fillFrom(look.sky);
    options.sky.check();
    FrameSettings settings = settingsFrom(options, look, outputs);
    const std::optional<FrameRange> frames = options.animation.range();
    if (frames) {
        checkFrameOutputs(outputs, *frames, settings);
    } else {
        checkOutputs(outputs);
    }

    const std::optional<FileCache> cache = options.cache.cache();
    LoadOptions loading = options.loading.parsed();
    loading.cache = cache ? &*cache : nullptr;
    SceneAhead ahead(options.scene, loading);
    const EarlyContext earlyContext;
    LoadedScene loaded = ahead.takeScene();
    options.animation.pose(loaded.scene, look.time);
    BroughtLook broughtLook(look, loaded);
    if (options.look.file) {
        loaded.files.emplace_back(*options.look.file);
    }
    for (const std::filesystem::path& output :
         frames ? allFrameFiles(outputs.files, *frames) : outputs.files) {
        refuseReplacing(output, loaded.files);
    }
    settings.sky = options.sky.parsed(loaded.scene);
    const Camera camera = look.camera && !options.camera
                              ? *look.camera
                              : chooseCamera(loaded.scene, options.camera,
                                             double(settings.width) / double(settings.height));

    const Context& context = earlyContext.get();
    if (const std::optional<BeamGoal> goal = options.beams.goal()) {
        while (ahead.takePictures(loaded)) {
        }
        settings.beams = chooseAndTell(loaded.scene, camera, settings, *goal);
    }
    const GlCounters before = glCounters();
    Clock::time_point start = Clock::now();
    std::optional<Progress> uploading(std::in_place, "uploading");
    Renderer renderer(loaded.scene, cache ? &*cache : nullptr);
    uploading.reset();
    letGoOfSurfacePictures(loaded.scene);
    double uploadMs = msSince(start);
    while (ahead.takePictures(loaded)) {
        start = Clock::now();
        renderer.usePictures();
        letGoOfSurfacePictures(loaded.scene);
        uploadMs += msSince(start);
    }
    const std::uint64_t uploadedBytes = glCounters().bytesAllocated - before.bytesAllocated;

    if (frames) {
        returnFreedMemory();
        renderFrames({loaded.scene, renderer, camera, settings, outputs, *frames,
                      options.animation.chosen(loaded.scene, look.time), options.animation.fresh,
                      newestOf(loaded.files), [&](Scene& scene) { broughtLook.bring(scene); }});
        tellOfPlan(renderer.lastPlan());
        return;
    }
    RenderStats stats = drawFrames(renderer, loaded.scene, camera, settings, options, before);
    tellOfPlan(renderer.lastPlan());
    stats.renderer = context.renderer();
    stats.load = loaded.stages;
    stats.load.push_back({"context", earlyContext.ms()});
    stats.load.push_back({"upload", uploadMs});
    stats.load.push_back({"shaders", glCounters().programsMs - before.programsMs});
    stats.uploadedBytes = uploadedBytes;
    stats.peakBytes = peakMemoryBytes();

    if (!options.stats.empty()) {
        stats.samples = renderer.beamSamples();
    }
    if (!options.stats.empty() && renderer.lastPlan().beams &&
        renderer.lastPlan().beams->shadowPyramid) {
        // In a frame of its own, of the same picture: counting takes time.
        settings.countRuns = true;
        renderer.draw(camera, settings);
        stats.runs = renderer.runCounts().value_or(gpu::RunCounts{});
    }

    tellOfFrames(options.scene, stats);
    const Progress progress("writing");
    writeOutputs(outputs, renderer.lastPlan(), renderer.targets());
    if (!options.stats.empty()) {
        writeStats(options.stats, stats);
    }
}

void addPictureOptions(CLI::App& command, RenderOptions& options) {
    addSceneOption(command, options.scene);
    options.loading.addTo(command);
    command
        .add_option("-o,--output", options.outputs,
                    "picture to write: .png for the screen, .exr in cd/m2; may be given several "
                    "times")
        ->type_name("FILE")
        ->allow_extra_args(false);
    options.look.addTo(command);
    addCameraOption(command, options.camera);
    addSizeOption(command, options.size);
    command
        .add_option("--exposure", options.exposure,
                    "exposure of the .png as EV100, -60..60, or auto; 1 more halves its brightness "
                    "(default: auto)")
        ->type_name("EV100|auto");
    addToneCurveOption(command, options.toneCurve);
    addAmbientOption(command, options.ambient);
    command
        .add_option("--illuminance", options.illuminance,
                    "show what light falls on surfaces: the .exr holds lux by channel, the .png "
                    "false colours over three decades up to LUX")
        ->type_name("LUX")
        ->check(expectPositive, "");
    command
        .add_option("--aov", options.layers,
                    "more layers of the .exr, by comma: beams, transmittance, depth, normal")
        ->type_name("LAYERS");
    command.add_option("--stats", options.stats, "write times and counters to this JSON file")
        ->type_name("FILE.json");
    command
        .add_option("--repeat", options.repeat,
                    "draw the frame so many times, 1..100000, and report medians")
        ->type_name("N")
        ->check(CLI::Range(1, 100000).description(""))
        ->capture_default_str();
    command.add_flag("--redraw", options.redraw,
                     "with --repeat: draw the shadow maps anew in every frame");
    command
        .add_flag("--still", options.still,
                  "with --repeat: keep the picture where nothing changed, as a viewer does")
        ->excludes("--redraw");
    command.add_flag("--verbose", options.verbose,
                     "say which OpenGL is used, what is drawn and how long it takes");
}

}  // namespace

void addRenderCommand(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "render", "Draws a picture, or the frames of an animation, without a window.");
    const auto options = std::make_shared<RenderOptions>();
    addPictureOptions(*command, *options);
    options->animation.addTo(*command);
    options->haze.addTo(*command);
    options->sky.addTo(*command);
    options->cache.addTo(*command);
    options->beams.addTo(*command);
    command->callback([options] { render(*options); });
}

}  // namespace ribalta
