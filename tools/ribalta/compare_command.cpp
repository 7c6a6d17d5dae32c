#include "compare_command.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/read_file.h"
#include "base/temporary_file.h"
#include "image/image_format.h"
#include "image/read_image.h"
#include "image/write_image.h"
#include "measure/display_picture.h"
#include "measure/error_picture.h"
#include "measure/picture_error.h"
#include "options.h"
#include "output_checks.h"
#include "parse_number.h"
#include "reference/reference_file.h"

namespace ribalta {
namespace {

struct CompareOptions {
    std::string a;
    std::string b;
    std::string layer;
    std::string exposure = "auto";
    std::string output;
    std::string scale = "auto";
    std::string json;
    std::optional<double> maxRelative;
    std::optional<double> maxDisplay;
    std::optional<double> maxFlip;
    std::optional<double> minPsnr;
};

/// What the comparison found. Without linear values there is no exposure either.
struct Comparison {
    std::optional<LinearError> linear;
    std::optional<double> ev100;
    DisplayError display;
    RgbPicture displayA;
    RgbPicture displayB;
};

struct ReadPicture {
    RgbPicture picture;
    bool isLinear = false;  ///< cd/m2; otherwise display values in 0..1
    std::string sky;        ///< as the picture says; empty: it does not
    std::string air;        ///< the sky's, likewise
};

// "" where the picture does not say so.
std::string textFact(const FloatImage& image, const char* name) {
    const auto fact = image.facts.find(name);
    const auto* text =
        fact == image.facts.end() ? nullptr : std::get_if<std::string>(&fact->second);
    return text != nullptr ? *text : "";
}

ReadPicture read(const std::string& path, const std::string& layer) {
    const ImageFormat format = imageFormat(readFile(path));
    ReadPicture result;
    result.isLinear = format == ImageFormat::kOpenExr || format == ImageFormat::kHdr;
    const FloatImage image = readFloatImage(path);
    result.sky = textFact(image, kSkyFact);
    result.air = textFact(image, kSkyAirFact);
    result.picture = pickLayer(image, layer, {path, ""});
    return result;
}

Comparison compareFiles(const CompareOptions& options) {
    const std::optional<double> given = parseExposure(options.exposure);
    ReadPicture a = read(options.a, options.layer);
    ReadPicture b = read(options.b, options.layer);
    if (a.isLinear != b.isLinear) {
        throw Error(ErrorKind::kBadInput, {options.a, ""},
                    std::string("holds ") +
                        (a.isLinear ? "luminance, the other picture display values"
                                    : "display values, the other picture luminance") +
                        "; give two .exr or two .png");
    }
    if (!b.isLinear && given) {
        throw Error(ErrorKind::kUsage, {"--exposure", ""},
                    options.b + " holds display values, which have been exposed; leave it out");
    }
    if (!a.sky.empty() && !b.sky.empty() && a.sky != b.sky) {
        throw Error(ErrorKind::kBadInput, {options.a, ""},
                    "is under another sky (" + a.sky + ") than " + options.b + " (" + b.sky +
                        "); draw one of them with the other's --sun, --altitude and --sky-orders");
    }
    if (!a.air.empty() && !b.air.empty() && a.air != b.air) {
        throw Error(ErrorKind::kBadInput, {options.a, ""},
                    "is of other air (" + a.air + ") than " + options.b + " (" + b.air +
                        "); draw one of them with the other's air, ground and sun");
    }
    refuseOtherSize(a.picture, b.picture, {options.a, ""});
    refuseNonFinite(a.picture, {options.a, ""});
    refuseNonFinite(b.picture, {options.b, ""});

    Comparison result;
    if (b.isLinear) {
        result.linear = linearError(a.picture, b.picture);
        result.ev100 = given ? *given : autoExposure(b.picture);
        result.displayA = displayPicture(a.picture, *result.ev100);
        result.displayB = displayPicture(b.picture, *result.ev100);
    } else {
        result.displayA = std::move(a.picture);
        result.displayB = std::move(b.picture);
    }
    result.display = displayError(result.displayA, result.displayB);
    return result;
}

nlohmann::json numberOrNull(double value) {
    return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json();
}

nlohmann::json toJson(const LargestError& largest) {
    return {{"x", largest.x}, {"y", largest.y}, {"channel", std::string(1, "RGB"[largest.channel])},
            {"a", largest.a}, {"b", largest.b}, {"error", largest.size()}};
}

nlohmann::json toJson(const CompareOptions& options, const Comparison& found) {
    const DisplayError& display = found.display;
    nlohmann::json linear;
    if (found.linear) {
        linear = {{"relative_rmse", numberOrNull(found.linear->relativeRmse)},
                  {"largest", toJson(found.linear->largest)}};
    }
    return {{"a", options.a},
            {"b", options.b},
            {"layer", options.layer},
            {"width", found.displayB.width},
            {"height", found.displayB.height},
            {"ev100", found.ev100 ? nlohmann::json(*found.ev100) : nlohmann::json()},
            {"linear", linear},
            {"display",
             {{"rmse_percent", display.rmsePercent},
              {"psnr_db", numberOrNull(display.psnr)},
              {"flip_mean", display.flipMean},
              {"flip_largest", display.flipLargest},
              {"largest", toJson(display.largest)}}}};
}

void printLargest(const char* what, const LargestError& largest, const char* unit) {
    std::printf("%s %.4g%s at %d,%d %c: %.6g, in B %.6g\n", what, largest.size(), unit, largest.x,
                largest.y, "RGB"[largest.channel], largest.a, largest.b);
}

void print(const CompareOptions& options, const Comparison& found) {
    const std::string layer = options.layer.empty() ? "" : ", layer " + options.layer;
    std::printf("%dx%d pixels%s\n", found.displayB.width, found.displayB.height, layer.c_str());
    if (found.linear) {
        std::printf("linear relative RMSE  %.6g (RMS of A - B / RMS of B)\n",
                    found.linear->relativeRmse);
        printLargest("largest linear error ", found.linear->largest, " cd/m2");
        std::printf("exposure              EV100 %.3f%s\n", *found.ev100,
                    options.exposure == "auto" ? ", found on B" : "");
    }
    const DisplayError& display = found.display;
    std::printf("tone-mapped RMSE      %.6g %% of full scale\n", display.rmsePercent);
    std::printf("PSNR                  %.4g dB at 8 bits\n", display.psnr);
    std::printf("FLIP                  %.6g mean, %.4g largest (67 pixels per degree)\n",
                display.flipMean, display.flipLargest);
    printLargest("largest shown error  ", display.largest, "");
}

// Full scale of the difference picture, in % of the display's.
double scaleOf(const CompareOptions& options, const Comparison& found) {
    if (options.scale != "auto") {
        return parseNumber<double>(options.scale).value();
    }
    const double largest = 100.0 * found.display.largest.size();
    return largest > 0.0 ? largest : 100.0;
}

void writeDifference(const CompareOptions& options, const Comparison& found) {
    const double scale = scaleOf(options, found);
    const BytePicture picture =
        errorPicture(found.displayA, found.displayB, scale, found.displayB.width);
    writePng(options.output, picture.width, picture.height, picture.rgb);
    std::fprintf(stderr, "%s: black is no difference, white %.4g %% of full scale and above\n",
                 options.output.c_str(), scale);
}

// "FLIP 0.2 is over 0.1, ..." or an empty text.
std::string overLimits(const CompareOptions& options, const Comparison& found) {
    std::string over;
    const auto check = [&](const char* what, double value, const std::optional<double>& limit,
                           bool atLeast) {
        // A difference that is no number is never within a limit.
        if (!limit || (atLeast ? value >= *limit : value <= *limit)) {
            return;
        }
        char text[96];
        std::snprintf(text, sizeof text, "%s%s %.6g is %s %.6g", over.empty() ? "" : ", ", what,
                      value, atLeast ? "under" : "over", *limit);
        over += text;
    };
    if (found.linear) {
        check("linear relative RMSE", found.linear->relativeRmse, options.maxRelative, false);
    }
    check("tone-mapped RMSE %", found.display.rmsePercent, options.maxDisplay, false);
    check("FLIP", found.display.flipMean, options.maxFlip, false);
    check("PSNR", found.display.psnr, options.minPsnr, true);
    return over;
}

void compare(const CompareOptions& options) {
    if (!options.output.empty()) {
        if (std::filesystem::path(options.output).extension() != ".png") {
            throw Error(ErrorKind::kUsage, {options.output, ""},
                        "a difference picture is written as .png");
        }
        refuseReplacing(options.output, {options.a, options.b});
        const TemporaryFile probe(options.output);
    }
    if (!options.json.empty() && options.json != "-") {
        refuseReplacing(options.json, {options.a, options.b});
        const TemporaryFile probe(options.json);
    }
    const Comparison found = compareFiles(options);
    if (options.maxRelative && !found.linear) {
        throw Error(ErrorKind::kUsage, {"--max-relative", ""},
                    "display values have no linear error; compare two .exr, or use --max-display");
    }
    if (options.json == "-") {
        std::printf("%s\n", toJson(options, found).dump(2).c_str());
    } else {
        print(options, found);
        if (!options.json.empty()) {
            writeFileAtomically(options.json, toJson(options, found).dump(2) + "\n");
        }
    }
    if (!options.output.empty()) {
        writeDifference(options, found);
    }
    const std::string over = overLimits(options, found);
    if (!over.empty()) {
        throw Error(ErrorKind::kJobFailed, {options.a, ""},
                    "differs from " + options.b + " by more than is allowed: " + over);
    }
}

std::string expectScale(const std::string& text) {
    return text == "auto" || expectPositive(text).empty()
               ? ""
               : "'" + text + "' is not auto or a number of % above 0";
}

void addLimits(CLI::App& command, CompareOptions& options) {
    const auto addLimit = [&](const char* name, std::optional<double>& limit, const char* what) {
        command.add_option(name, limit, what)->type_name("X")->check(expectNotNegative, "");
    };
    addLimit("--max-relative", options.maxRelative,
             "fail (exit code 1) where the linear relative RMSE is over this");
    addLimit("--max-display", options.maxDisplay,
             "fail where the tone-mapped RMSE is over this, in % of full scale");
    addLimit("--max-flip", options.maxFlip, "fail where the mean of FLIP, 0..1, is over this");
    addLimit("--min-psnr", options.minPsnr, "fail where the PSNR is under this, in dB");
}

}  // namespace

void addCompareCommand(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "compare", "Says how far picture A is from picture B, which is taken for right.");
    const auto options = std::make_shared<CompareOptions>();
    command->add_option("A", options->a, "picture: two .exr in cd/m2, or two .png")
        ->type_name("FILE")
        ->required();
    command->add_option("B", options->b, "the picture that A should be")
        ->type_name("FILE")
        ->required();
    command
        ->add_option("--layer", options->layer,
                     "compare this layer of the .exr, such as beams (default: the picture)")
        ->type_name("NAME");
    command
        ->add_option("--exposure", options->exposure,
                     "exposure at which .exr are tone mapped, as EV100, -60..60; auto: as the "
                     "renderer would find it for B")
        ->type_name("EV100|auto")
        ->capture_default_str();
    command
        ->add_option("-o,--output", options->output,
                     "difference picture to write: the largest channel's error of each pixel")
        ->type_name("FILE.png");
    command
        ->add_option("--scale", options->scale,
                     "error that is white in the difference picture, in % of full scale; auto: "
                     "the largest there is")
        ->type_name("PERCENT|auto")
        ->check(expectScale, "")
        ->capture_default_str();
    command->add_option("--json", options->json, "write the numbers to this file; - is stdout")
        ->type_name("FILE|-");
    addLimits(*command, *options);
    command->callback([options] { compare(*options); });
}

}  // namespace ribalta
