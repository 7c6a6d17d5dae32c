#include "render_outputs.h"

#include <algorithm>
#include <optional>
#include <sstream>

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "base/temporary_file.h"
#include "frame_files.h"
#include "image/write_image.h"
#include "output_checks.h"
#include "reference/reference_file.h"

namespace ribalta {
namespace {

void refuseFolder(const std::filesystem::path& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
        throw Error(ErrorKind::kUsage, {path.string(), ""}, "is a folder; give a file name in it");
    }
}

bool anyEndsWith(const RenderOutputs& outputs, const char* ending) {
    return std::any_of(outputs.files.begin(), outputs.files.end(),
                       [&](const auto& file) { return endingOf(file) == ending; });
}

}  // namespace

bool RenderOutputs::wantsDisplay() const {
    return files.empty() || anyEndsWith(*this, ".png") ||
           std::any_of(files.begin(), files.end(), isVideo);
}

bool RenderOutputs::wantsExr() const {
    return anyEndsWith(*this, ".exr");
}

void checkOutputs(const RenderOutputs& outputs) {
    for (const std::filesystem::path& file : outputs.files) {
        if (endingOf(file) != ".png" && endingOf(file) != ".exr") {
            refuseFolder(file);
            throw Error(ErrorKind::kUsage, {file.string(), ""},
                        isVideo(file) ? "one picture is no film; give the frames, as --frames 0:47"
                                      : "the ending says no format; use .png or .exr");
        }
    }
    if (!outputs.stats.empty() && endingOf(outputs.stats) != ".json") {
        refuseFolder(outputs.stats);
        throw Error(ErrorKind::kUsage, {outputs.stats.string(), ""},
                    "statistics are written as JSON; use the ending .json");
    }
    const FrameLayers& layers = outputs.layers;
    if ((layers.beams || layers.transmittance || layers.depth || layers.normal) &&
        !outputs.wantsExr()) {
        throw CLI::ValidationError("--aov", "only an .exr has layers; add -o FILE.exr");
    }
    // Opening each now, uncommitted, shows in time what would fail after the work.
    for (const std::filesystem::path& file : outputs.files) {
        const TemporaryFile probe(file);
    }
    if (!outputs.stats.empty()) {
        const TemporaryFile probe(outputs.stats);
    }
}

FrameLayers parseLayers(const std::string& text) {
    FrameLayers layers;
    std::istringstream names(text);
    std::string name;
    while (std::getline(names, name, ',')) {
        if (name == "beams") {
            layers.beams = true;
        } else if (name == "transmittance") {
            layers.transmittance = true;
        } else if (name == "depth") {
            layers.depth = true;
        } else if (name == "normal") {
            layers.normal = true;
        } else {
            throw CLI::ValidationError(
                "--aov", "'" + name + "' is none of beams, transmittance, depth, normal");
        }
    }
    return layers;
}

SkyOverScene skyOf(const SkyDrawing& drawing) {
    SkyOverScene sky{drawing.air, drawing.orders, drawing.towardsSun, drawing.altitudeMetres,
                     drawing.sunLamp};
    if (const auto* tables = std::get_if<PrecomputedSkySettings>(&drawing.model)) {
        sky.orders = {tables->orders, false};
    } else if (std::holds_alternative<ChapmanSky>(drawing.model)) {
        sky.orders = {1, false};
    }
    return sky;
}

void writeOutputs(const RenderOutputs& outputs, const FramePlan& plan,
                  const FrameTargets& targets) {
    std::optional<FloatImage> frame;
    for (const std::filesystem::path& file : outputs.files) {
        if (endingOf(file) == ".png") {
            writePng(file, plan.settings.width, plan.settings.height, readDisplay(targets));
            continue;
        }
        if (!frame) {
            frame = readFrame(plan, targets, outputs.layers);
            if (plan.sky) {
                frame->facts[kSkyFact] = describeSky(skyOf(plan.sky->drawing));
                frame->facts[kSkyAirFact] = describeAir(plan.sky->drawing.air);
            }
            warnOfNonFinite(*frame, file);
        }
        writeExr(file, *frame);
    }
}

}  // namespace ribalta
