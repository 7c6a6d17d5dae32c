#include "sweep_command.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "base/log.h"
#include "gl/context.h"
#include "haze_options.h"
#include "interrupts.h"
#include "loading_options.h"
#include "look_options.h"
#include "measure/pessoa2007.h"
#include "measure/sweep_report.h"
#include "options.h"
#include "sweep_plan.h"
#include "sweep_run.h"
#include "sweep_sky.h"

namespace ribalta {
namespace {

constexpr const char* kOptionsOfSkies[] = {"--preset", "--sky",    "--size",
                                           "--repeat", "--warmup", "--max-point-seconds",
                                           "--output", "--fresh",  "--verbose"};

struct SweepOptions {
    std::vector<std::string> scenes;
    LoadingOptions loading;
    std::vector<std::string> cameras;
    std::string planes = "8:1024";
    std::string beams = "all";
    std::string tolerance;
    std::string size = "1280x720";
    HazeOptions haze;
    std::optional<double> ambient;
    LookOptions look;
    bool frames = false;
    std::string visibility = "shadow-map";
    int repeat = 7;
    int warmup = 2;
    double maxPointSeconds = 60.0;
    double target = 0.5;
    std::string preset;
    std::string sky = "all";
    std::filesystem::path output;
    bool fresh = false;
    bool verbose = false;
    CLI::Option* planesOption = nullptr;
    CLI::Option* beamsOption = nullptr;
    CLI::Option* sizeOption = nullptr;
};

// What the look says in place of what was not given.
void takeFromLook(const SweepOptions& options, const Look& look, SweepGrid& grid) {
    grid.settings.ev100 = look.ev100;
    grid.settings.toneCurve = look.toneCurve;
    grid.ownCamera = look.camera;
    if (options.planesOption->count() == 0) {
        grid.planes = {look.beams.planes};
    }
    if (options.beamsOption->count() == 0) {
        grid.methods = {look.beams.method};
    }
    if (options.tolerance.empty() && look.beams.tolerance) {
        grid.tolerances = {*look.beams.tolerance};
    }
    if (options.sizeOption->count() == 0 && look.size) {
        grid.sizes = {{look.size->x, look.size->y}};
    }
}

// A look is of one scene, and a sweep's pictures are of beams.
void checkLook(const SweepOptions& options, const Look& look) {
    if (options.look.file && !options.preset.empty()) {
        throw CLI::ValidationError("--look", "and a preset have settings of their own; give one");
    }
    if (options.look.file && options.scenes.size() > 1) {
        throw CLI::ValidationError("--look", "is of one scene; give one");
    }
    if (look.sky) {
        throw Error(ErrorKind::kBadInput, {*options.look.file, "/sky"},
                    "sweeps measure beams without a sky; take it out of a copy of the look");
    }
}

SweepGrid gridFrom(const SweepOptions& options) {
    const Look look = options.look.read();
    checkLook(options, look);
    SweepGrid grid;
    grid.cameras = options.cameras;
    grid.planes = parsePlaneCounts(options.planes);
    grid.methods = parseMethods(options.beams);
    grid.tolerances = parseTolerances(options.tolerance);
    grid.settings.haze = options.haze.parsed(look.haze);
    grid.settings.ambientLux = options.ambient.value_or(look.ambientLux);
    grid.pessoa2007 = !options.preset.empty();
    grid.sizes = parseSizes(options.size);
    if (options.look.file) {
        takeFromLook(options, look, grid);
    }
    if (!grid.pessoa2007) {
        return grid;
    }
    if (options.planesOption->count() > 0) {
        throw CLI::ValidationError("--planes", "the preset has counts of its own; leave it out");
    }
    if (options.sizeOption->count() == 0) {
        grid.sizes = {{640, 480}};
    }
    if (options.beamsOption->count() == 0) {
        grid.methods = {BeamMethod::kPlanes};
        if (BeamSettings{}.method != BeamMethod::kPlanes) {
            grid.methods.push_back(BeamSettings{}.method);
        }
    }
    return grid;
}

std::vector<std::string> visibilitiesFrom(const std::string& text) {
    if (text == "none") {
        return {};
    }
    if (text == "both") {
        return {"shadow-map", "geometry"};
    }
    return {text};
}

std::vector<SweepScene> loadScenes(const std::vector<std::string>& paths,
                                   const LoadOptions& options, const LookOptions& look) {
    refuseNamesakes(paths);
    std::vector<SweepScene> scenes;
    for (const std::string& path : paths) {
        scenes.push_back(loadSweepScene(path, options, look));
        if (!scenes.back().loaded && paths.size() == 1) {
            static_cast<void>(
                loadGltf(path, options));  // nothing is left to measure: the error itself
        }
    }
    return scenes;
}

void printTimes(const std::vector<SweepRecord>& records, double target) {
    const std::vector<TimeToError> times = timesToError(records, target);
    if (times.empty()) {
        return;
    }
    std::printf("GPU time of the beams to %g %% tone-mapped RMSE\n", target);
    for (const TimeToError& each : times) {
        std::printf("  %-44s %-12s ", each.view.c_str(), each.method.c_str());
        if (each.timeMs) {
            std::printf("%10.2f ms", *each.timeMs);
        } else {
            std::printf("not within %.2f ms", each.longestMs);
        }
        std::printf("   least error %.3g %%\n", each.leastError);
    }
}

void endBySignal(const SweepRun& run, int signal) {
    logWarning("interrupted: " + std::to_string(run.records().size()) + " of " +
               std::to_string(run.pointCount()) +
               " points are done and kept; the same command goes on from there");
    std::fflush(nullptr);
    std::raise(signal);
}

// Options of beams mean nothing to skies, and the other way round.
void refuseOptionsOfBeams(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options()) {
        const std::string name = option->get_name();
        const bool known = std::any_of(std::begin(kOptionsOfSkies), std::end(kOptionsOfSkies),
                                       [&](const char* each) { return name == each; });
        if (option->count() > 0 && !known) {
            throw CLI::ValidationError(name,
                                       "means nothing to the preset pinheiro2014; leave it out");
        }
    }
}

void sweepSky(const SweepOptions& options) {
    SkySweepSettings settings;
    settings.folder = options.output;
    settings.rows = parseSkyRows(options.sky);
    settings.measure.repeats = options.repeat;
    settings.measure.warmups = options.warmup;
    settings.measure.maxPointSeconds = options.maxPointSeconds;
    settings.fresh = options.fresh;
    settings.size = parseSize(options.sizeOption->count() > 0 ? options.size : "480x270");
    const Context context;
    logVerbose("OpenGL: " + context.renderer() + ", " + context.version());
    const std::vector<SkyRecord> records = sweepSkies(settings, context);
    std::printf("%s", skyTable(records).c_str());
    const auto failed = std::size_t(std::count_if(
        records.begin(), records.end(), [](const SkyRecord& record) { return record.failed; }));
    std::printf("%zu pictures, %zu failed; %s\n", records.size(), failed,
                (options.output / "report.html").c_str());
    if (const int signal = InterruptWatch::noted(); signal != 0) {
        logWarning("interrupted; references that were drawn are kept");
        std::fflush(nullptr);
        std::raise(signal);
    }
    if (failed > 0) {
        throw Error(ErrorKind::kJobFailed, {options.output.string(), ""},
                    "partial: " + std::to_string(failed) + " of " + std::to_string(records.size()) +
                        " pictures failed; sweep.csv says why");
    }
}

void sweep(const CLI::App& command, const SweepOptions& options) {
    setVerbose(options.verbose);
    if (options.preset == "pinheiro2014") {
        refuseOptionsOfBeams(command);
        sweepSky(options);
        return;
    }
    if (options.scenes.empty()) {
        throw CLI::RequiredError("scenes");
    }
    if (command.get_option("--sky")->count() > 0) {
        throw CLI::ValidationError("--sky", "needs --preset pinheiro2014");
    }
    const SweepGrid grid = gridFrom(options);
    SweepSettings settings;
    settings.folder = options.output;
    settings.measure.repeats = options.repeat;
    settings.measure.warmups = options.warmup;
    settings.measure.maxPointSeconds = options.maxPointSeconds;
    settings.visibilities = visibilitiesFrom(options.visibility);
    settings.targetPercent = options.target;
    settings.fresh = options.fresh;
    settings.frames = options.frames;
    SweepPlan plan =
        planSweep(loadScenes(options.scenes, options.loading.parsed(), options.look), grid);

    const Context context;
    logVerbose("OpenGL: " + context.renderer() + ", " + context.version());
    SweepRun run(std::move(plan), std::move(settings), context);
    const int signal = run.run();

    printTimes(run.records(), options.target);
    if (grid.pessoa2007) {
        std::printf("%s", thesisTable(run.records()).c_str());
    }
    const std::size_t failed = run.count(SweepRecord::Status::kFailed);
    std::printf("%zu points: %zu measured (%zu of them before), %zu skipped, %zu failed; %s\n",
                run.pointCount(), run.count(SweepRecord::Status::kMeasured), run.keptCount(),
                run.count(SweepRecord::Status::kSkipped), failed,
                (options.output / "report.html").c_str());
    if (signal != 0) {
        endBySignal(run, signal);
    }
    if (failed > 0) {
        throw Error(ErrorKind::kJobFailed, {options.output.string(), ""},
                    "partial: " + std::to_string(failed) + " of " +
                        std::to_string(run.pointCount()) +
                        " points failed; sweep.csv says why, the same command tries them again");
    }
}

void addPointOptions(CLI::App& command, SweepOptions& options) {
    command
        .add_option("scenes", options.scenes,
                    "glTF scenes, .gltf or .glb; the preset pinheiro2014 needs none")
        ->type_name("FILE");
    options.loading.addTo(command);
    command
        .add_option("--camera", options.cameras,
                    "camera, by name or counted from 0, in each scene that has it; several times "
                    "for several; all: every one (default: each scene's first)")
        ->type_name("NAME|INDEX|all")
        ->allow_extra_args(false);
    options.sizeOption =
        command.add_option("--size", options.size, "sizes of the picture in pixels, by comma")
            ->type_name("WxH[,...]")
            ->capture_default_str();
    options.beamsOption =
        command.add_option("--beams", options.beams, "methods that draw beams, by comma, or all")
            ->type_name("METHODS")
            ->capture_default_str();
    options.planesOption =
        command
            .add_option("--planes", options.planes,
                        "counts of sheets: FIRST:LAST doubles, FIRST:LAST:STEP adds, "
                        "FIRST:LAST:FACTORx multiplies, or a list by comma; 1..65536")
            ->type_name("COUNTS")
            ->capture_default_str();
    command
        .add_option("--tolerance", options.tolerance,
                    "tolerances of the method adaptive, by comma, each 0..1 of full scale: a curve "
                    "for each (default: the renderer's own)")
        ->type_name("SHARES");
    options.haze.addTo(command);
    addAmbientOption(command, options.ambient);
    options.look.addTo(command);
    command
        .add_option("--preset", options.preset,
                    "pessoa2007: the six configurations of the thesis, at 640x480, its table "
                    "printed beside ours; pinheiro2014: skies instead of beams, from the thesis's "
                    "six viewpoints, at 480x270: memory, times, error against the reference")
        ->type_name("NAME")
        ->check(CLI::IsMember({"pessoa2007", "pinheiro2014"}).description(""));
    command
        .add_option("--sky", options.sky,
                    "with the preset pinheiro2014: models by comma, or all: auto, auto-once, "
                    "bruneton, bruneton-once, bruneton-rayleigh, single, single-2008, "
                    "single-rayleigh, chapman, chapman-better")
        ->type_name("NAMES")
        ->capture_default_str();
}

void addMeasureOptions(CLI::App& command, SweepOptions& options) {
    command
        .add_option("--reference-visibility", options.visibility,
                    "what pictures are compared with: shadow-map, whose visibility is the "
                    "renderer's own, so that the error is that of integration; geometry, the "
                    "truth; both; none")
        ->type_name("KIND")
        ->check(CLI::IsMember({"shadow-map", "geometry", "both", "none"}).description(""))
        ->capture_default_str();
    command.add_option("--repeat", options.repeat, "frames that are measured at a point, 1..10000")
        ->type_name("N")
        ->check(CLI::Range(1, 10000).description(""))
        ->capture_default_str();
    command.add_option("--warmup", options.warmup, "frames before those, 0..1000")
        ->type_name("N")
        ->check(CLI::Range(0, 1000).description(""))
        ->capture_default_str();
    command
        .add_option("--max-point-seconds", options.maxPointSeconds,
                    "time that a point's frames may take together; where it is short, fewer are "
                    "drawn, and a point whose one frame would take longer is skipped")
        ->type_name("SECONDS")
        ->check(expectPositive, "")
        ->capture_default_str();
    command
        .add_option("--target", options.target,
                    "tone-mapped RMSE in % at which the report compares times")
        ->type_name("PERCENT")
        ->check(expectPositive, "")
        ->capture_default_str();
    command
        .add_option("-o,--output", options.output,
                    "folder for sweep.csv, sweep.json, report.html; where it holds a sweep "
                    "already, that one goes on")
        ->type_name("FOLDER")
        ->required();
    command.add_flag("--keep-frames", options.frames,
                     "keep every point's frame at full size, as `ribalta render` writes it");
    command.add_flag("--fresh", options.fresh, "measure and draw all anew");
    command.add_flag("--verbose", options.verbose, "say what is measured, point by point");
}

}  // namespace

void addSweepCommand(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "sweep", "Measures run time against error for many settings, and reports it.");
    const auto options = std::make_shared<SweepOptions>();
    addPointOptions(*command, *options);
    addMeasureOptions(*command, *options);
    command->callback([command, options] { sweep(*command, *options); });
}

}  // namespace ribalta
