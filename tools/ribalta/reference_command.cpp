#include "reference_command.h"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "animation_options.h"
#include "base/error.h"
#include "base/log.h"
#include "base/progress.h"
#include "gl/context.h"
#include "haze_options.h"
#include "image/write_image.h"
#include "load_scene.h"
#include "loading_options.h"
#include "measure/drawn_frame.h"
#include "options.h"
#include "output_checks.h"
#include "parse_number.h"
#include "reference/reference_file.h"
#include "reference/reference_picture.h"
#include "render/renderer.h"
#include "render_outputs.h"
#include "sky_options.h"

namespace ribalta {
namespace {

using Clock = std::chrono::steady_clock;

struct ReferenceOptions {
    std::string scene;
    LoadingOptions loading;
    std::filesystem::path output;
    std::optional<std::string> camera;
    std::optional<std::string> size;
    HazeOptions haze;
    SkyOptions sky;
    AnimationOptions animation;
    std::optional<double> ambient;
    std::string visibility = "geometry";
    double error = 1e-5;
    std::string layers;
    bool verbose = false;
};

ReferenceLayers layersFrom(const ReferenceOptions& options) {
    const FrameLayers asked = parseLayers(options.layers);
    if (asked.normal) {
        throw CLI::ValidationError(
            "--aov", "a reference has the layers beams (always), transmittance and depth");
    }
    return {asked.transmittance, asked.depth};
}

void checkOutput(const std::filesystem::path& file) {
    RenderOutputs outputs;
    outputs.files = {file};
    checkOutputs(outputs);
    if (!outputs.wantsExr()) {
        throw Error(ErrorKind::kUsage, {file.string(), ""},
                    "a reference is written as scene-linear light; use the ending .exr");
    }
}

DrawnFrame drawWithOpenGL(const Scene& scene, const ReferenceSettings& settings) {
    const Progress progress("drawing");
    const Context context;
    logVerbose("OpenGL: " + context.renderer() + ", " + context.version());
    Renderer renderer(scene);
    return drawForReference(renderer, scene, settings);
}

void tellOfUnseen(const Scene& scene) {
    if (const std::size_t unseen = countUnseenPrimitives(scene); unseen > 0) {
        logWarning(std::to_string(unseen) +
                   " primitives of points or lines are not in a reference by geometry");
    }
}

void tellOfResult(const ReferencePicture& picture, double seconds, double asked) {
    std::printf(
        "%dx%d in %.1f s; estimated error of a pixel's beams, relative: largest %.2g, RMS %.2g\n",
        picture.width, picture.height, seconds, picture.largestError, picture.rmsError);
    if (picture.largestError > asked) {
        char line[160];
        std::snprintf(line, sizeof line,
                      "the error asked for, %.2g, was not reached everywhere: up to %.2g is left",
                      asked, picture.largestError);
        logWarning(line);
    }
}

void tellOfSky(const SkyError& error) {
    std::printf("estimated error of the sky, relative: largest %.2g, RMS %.2g\n", error.largest,
                error.rms);
}

// What of the options a sky does not go with.
void checkSky(const ReferenceOptions& options, const Haze& haze) {
    options.sky.check();
    if (options.sky.sky == "none") {
        return;
    }
    if (haze.extinctionPerMetre() > 0.0) {
        throw CLI::ValidationError("--haze", "a reference under a sky has no haze; give --haze 0");
    }
    if (options.visibility != "geometry") {
        throw CLI::ValidationError("--visibility",
                                   "a reference under a sky is of the scene's own triangles; give "
                                   "--visibility geometry");
    }
}

void drawReferenceFile(const ReferenceOptions& options) {
    setVerbose(options.verbose);
    ReferenceSettings settings;
    const PictureSize size = parseSize(options.size);
    settings.width = size.width;
    settings.height = size.height;
    settings.haze = options.haze.parsed();
    settings.ambientLux = options.ambient.value_or(settings.ambientLux);
    settings.relativeError = options.error;
    checkSky(options, settings.haze);
    const ReferenceLayers layers = layersFrom(options);
    checkOutput(options.output);

    LoadedScene loaded = loadScene(options.scene, options.loading.parsed());
    options.animation.pose(loaded.scene);
    refuseReplacing(options.output, loaded.files);
    settings.camera = chooseCamera(loaded.scene, options.camera, double(size.width) / size.height);

    if (const std::optional<SkyDrawing> sky = options.sky.parsed(loaded.scene)) {
        settings.sky = skyOf(*sky);
        warnIfBelowGround(
            skyEye(sky->air, sky->altitudeMetres, sky->towardsSun, settings.camera.frame.position));
    }

    const Clock::time_point start = Clock::now();
    std::optional<DrawnFrame> drawn;
    if (options.visibility == "shadow-map") {
        drawn = drawWithOpenGL(loaded.scene, settings);
        settings.drawn = &*drawn;
    } else {
        tellOfUnseen(loaded.scene);
    }
    std::optional<Progress> progress(std::in_place, "tracing", std::size_t(size.height));
    const ReferencePicture picture = drawReference(loaded.scene, settings, &*progress);
    progress.emplace("writing");
    const ReferenceView view =
        describeReference(std::filesystem::path(options.scene).filename().string(), settings);
    FloatImage image = referenceImage(picture, settings, view, layers);
    image.facts["version"] = RIBALTA_VERSION;
    warnOfNonFinite(image, options.output);
    writeExr(options.output, image);
    progress.reset();
    tellOfResult(picture, std::chrono::duration<double>(Clock::now() - start).count(),
                 options.error);
    if (settings.sky) {
        tellOfSky(picture.skyError);
    }
}

std::string expectError(const std::string& text) {
    const std::optional<double> value = parseNumber<double>(text);
    return value && *value >= 1e-9 && *value <= 0.1 ? ""
                                                    : "'" + text + "' is not a number in 1e-9..0.1";
}

void addOptions(CLI::App& command, ReferenceOptions& options) {
    addSceneOption(command, options.scene);
    options.loading.addTo(command);
    command.add_option("-o,--output", options.output, "picture to write: .exr in cd/m2")
        ->type_name("FILE.exr")
        ->required();
    addCameraOption(command, options.camera);
    addSizeOption(command, options.size);
    options.haze.addTo(command);
    options.sky.addReferenceTo(command);
    options.animation.addMomentTo(command);
    addAmbientOption(command, options.ambient);
    command
        .add_option("--visibility", options.visibility,
                    "what blocks light: geometry, the scene's own triangles, or shadow-map, the "
                    "maps that render draws, whose surfaces are then taken too")
        ->type_name("KIND")
        ->check(CLI::IsMember({"geometry", "shadow-map"}).description(""))
        ->capture_default_str();
    command
        .add_option("--error", options.error,
                    "relative error asked of each pixel's beams, 1e-9..0.1; what was reached is "
                    "printed")
        ->type_name("NUMBER")
        ->check(expectError, "")
        ->capture_default_str();
    command
        .add_option("--aov", options.layers,
                    "more layers, by comma: transmittance, depth; beams are always there")
        ->type_name("LAYERS");
    command.add_flag("--verbose", options.verbose, "say what is loaded and drawn");
}

}  // namespace

void addReferenceCommand(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "reference", "Computes one frame in double precision, to measure drawn frames against.");
    const auto options = std::make_shared<ReferenceOptions>();
    addOptions(*command, *options);
    command->callback([options] { drawReferenceFile(*options); });
}

}  // namespace ribalta
