#include "options.h"

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "base/log.h"
#include "parse_number.h"

namespace ribalta {
namespace {

constexpr int kMaxSide = 16384;
constexpr int kMaxCells = 1024;
constexpr double kMaxLux = 1e9;

PictureSize parsePair(const char* option, const std::string& text, int limit) {
    const std::size_t cross = text.find('x');
    const auto width = parseNumber<int>(text.substr(0, cross));
    const auto height =
        cross == std::string::npos ? std::nullopt : parseNumber<int>(text.substr(cross + 1));
    if (!width || !height || *width < 1 || *height < 1 || *width > limit || *height > limit) {
        throw CLI::ValidationError(
            option, "'" + text + "' is not WIDTHxHEIGHT, each 1.." + std::to_string(limit));
    }
    return {*width, *height};
}

}  // namespace

void addSceneOption(CLI::App& command, std::string& scene) {
    command.add_option("scene", scene, "glTF scene, .gltf or .glb")->type_name("FILE")->required();
}

void addCameraOption(CLI::App& command, std::optional<std::string>& camera) {
    command
        .add_option("--camera", camera,
                    "camera, by name or counted from 0 (default: the first; without any, one that "
                    "frames the scene)")
        ->type_name("NAME|INDEX");
}

void addSizeOption(CLI::App& command, std::optional<std::string>& size) {
    command.add_option("--size", size, "size of the picture in pixels (default: 1280x720)")
        ->type_name("WxH");
}

void addAmbientOption(CLI::App& command, std::optional<double>& lux) {
    command.add_option("--ambient", lux, "even light from all around in lux, 0..1e9 (default: 1)")
        ->type_name("LUX")
        ->check(expectLux, "");
}

void addToneCurveOption(CLI::App& command, std::optional<ToneCurve>& curve) {
    const auto take = [&curve](const std::string& text) {
        curve = valueIn(toneCurves(), text);
        if (!curve) {
            throw CLI::ValidationError("--tone-curve",
                                       "'" + text + "' is none of: " + listOf(toneCurves()));
        }
    };
    command
        .add_option_function<std::string>(
            "--tone-curve", take,
            "how the .png shows light that is brighter than a screen: neutral (colours kept, "
            "highlights rolled off), agx (as Blender since 4.0), aces, linear (cut off) (default: "
            "neutral)")
        ->type_name(listOf(toneCurves(), "|"));
}

PictureSize parseSize(const std::string& text) {
    return parsePair("--size", text, kMaxSide);
}

PictureSize parseSize(const std::optional<std::string>& text, const PictureSize& otherwise) {
    return text ? parseSize(*text) : otherwise;
}

PictureSize parseCells(const std::string& text) {
    return parsePair("--cells", text, kMaxCells);
}

void parseHaze(const std::string& text, Haze& haze) {
    const std::size_t comma = text.find(',');
    const auto scattering = parseNumber<double>(text.substr(0, comma));
    const auto absorption =
        comma == std::string::npos ? 0.0 : parseNumber<double>(text.substr(comma + 1));
    if (!scattering || !absorption || *scattering < 0.0 || *absorption < 0.0) {
        throw CLI::ValidationError(
            "--haze",
            "'" + text + "' is not SCATTERING[,ABSORPTION], both in 1/m and not negative");
    }
    haze.scatteringPerMetre = *scattering;
    haze.absorptionPerMetre = *absorption;
}

void parsePhase(const std::string& text, PhaseFunction& phase) {
    using Kind = PhaseFunction::Kind;
    const std::size_t colon = text.find(':');
    const std::string name = text.substr(0, colon);
    const std::optional<Kind> kind = valueIn(phaseFunctions(), name);
    const bool needsG = kind && PhaseFunction{*kind}.hasG();
    const auto g =
        colon == std::string::npos ? std::nullopt : parseNumber<double>(text.substr(colon + 1));
    const bool well = needsG ? g && std::abs(*g) < 1.0 : colon == std::string::npos;
    if (!kind || !well) {
        throw CLI::ValidationError("--phase", "'" + text +
                                                  "' is not gibbons, isotropic, rayleigh, hg:G or "
                                                  "cornette-shanks:G with -1 < G < 1");
    }
    phase.kind = *kind;
    phase.g = g.value_or(0.0);
}

std::optional<double> parseExposure(const std::string& text) {
    if (text == "auto") {
        return std::nullopt;
    }
    const auto ev100 = parseNumber<double>(text);
    if (!ev100 || std::abs(*ev100) > 60.0) {
        throw CLI::ValidationError("--exposure",
                                   "'" + text + "' is not auto or an EV100 in -60..60");
    }
    return ev100;
}

std::string expectPositive(const std::string& text) {
    return parseNumber<double>(text).value_or(0.0) > 0.0 ? ""
                                                         : "'" + text + "' is not a number above 0";
}

std::string expectNotNegative(const std::string& text) {
    return parseNumber<double>(text).value_or(-1.0) >= 0.0
               ? ""
               : "'" + text + "' is not a number, 0 or above";
}

std::string expectShare(const std::string& text) {
    const double value = parseNumber<double>(text).value_or(-1.0);
    return value >= 0.0 && value <= 1.0 ? "" : "'" + text + "' is not a number in 0..1";
}

std::string expectLux(const std::string& text) {
    const double value = parseNumber<double>(text).value_or(-1.0);
    return value >= 0.0 && value <= kMaxLux
               ? ""
               : "'" + text + "' is not an illuminance in lux, 0..1e9 (the sun's is 1e5)";
}

Camera chooseCamera(const Scene& scene, const std::optional<std::string>& nameOrIndex,
                    double aspectRatio) {
    if (!nameOrIndex) {
        if (scene.cameras.empty()) {
            logWarning("the file has no camera; one that frames the scene is made");
            return makeFramingCamera(tightSceneBounds(scene), aspectRatio);
        }
        return scene.cameras.front();
    }
    for (const Camera& camera : scene.cameras) {
        if (camera.name == *nameOrIndex) {
            return camera;
        }
    }
    const auto index = parseNumber<std::size_t>(*nameOrIndex);
    if (index && *index < scene.cameras.size()) {
        return scene.cameras[*index];
    }
    std::string there;
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
        there += (i == 0 ? "" : ", ") + std::to_string(i) + " " + scene.cameras[i].name;
    }
    throw Error(ErrorKind::kUsage, {"--camera", ""},
                "no camera '" + *nameOrIndex + "'; " +
                    (there.empty() ? "the file has none, leave the option out to frame the scene"
                                   : "there are: " + there));
}

}  // namespace ribalta
