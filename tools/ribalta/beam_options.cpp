#include "beam_options.h"

#include <CLI/CLI.hpp>

#include "options.h"
#include "parse_number.h"

namespace ribalta {
namespace {

constexpr double kMaxBudgetMs = 600e3;
constexpr double kMinErrorPercent = 0.001;

std::vector<std::string> methodNames() {
    std::vector<std::string> names = {"auto"};
    for (const Named<BeamMethod>& each : beamMethods()) {
        names.emplace_back(each.name);
    }
    return names;
}

// The number before a unit; `expected` says what was.
double parseWithUnit(const std::string& option, const std::string& text, const std::string& unit,
                     double low, double high, const std::string& expected) {
    const std::size_t digits = text.ends_with(unit) ? text.size() - unit.size() : text.size();
    const std::optional<double> value = parseNumber<double>(text.substr(0, digits));
    if (!value || *value < low || *value > high) {
        throw CLI::ValidationError(option, "'" + text + "' is not " + expected);
    }
    return *value;
}

}  // namespace

void BeamOptions::addTo(CLI::App& command) {
    command
        .add_option("--beams", method,
                    "how beams are drawn: adaptive (sheets within each beam at every fourth pixel "
                    "and wherever else the screen would show it), clipped (at every pixel), march "
                    "(even steps), planes (through the whole view, Pessoa 2007), or auto: what "
                    "reaches --budget or --error on this machine in this view (default: " +
                        std::string(name(BeamSettings{}.method)) + ")")
        ->type_name("METHOD")
        ->check(CLI::IsMember(methodNames()).description(""));
    command
        .add_option("--planes", planes,
                    "sheets a beam, or planes of the view, 1..65536 (default: " +
                        std::to_string(BeamSettings{}.planes) + ")")
        ->type_name("N")
        ->check(CLI::Range(1, 65536).description(""));
    command.add_option("--budget", budget, "with auto: time of the beams in a frame, e.g. 4ms")
        ->type_name("TIME");
    command
        .add_option("--error", error,
                    "with auto: root mean square error of the picture on the screen, e.g. 0.5% "
                    "(the default goal)")
        ->type_name("PERCENT")
        ->excludes("--budget");
    command
        .add_option("--tolerance", tolerance,
                    "with adaptive: how far a pixel may be off by interpolation, as a share of "
                    "the screen's full scale, 0..1 (default: 0.8 / planes, at most 0.1)")
        ->type_name("SHARE")
        ->check(expectShare, "");
    command
        .add_option("--cells", cells,
                    "with planes: cells, 1..1024 each way, on whose corners the smooth factor is "
                    "evaluated (default: at every pixel)")
        ->type_name("QxQ");
    command
        .add_option("--dt", spacingMetres,
                    "with planes: their distance in metres (default: spread over the scene)")
        ->type_name("METRES")
        ->check(expectPositive, "");
    command.add_flag("--eight-bit", eightBit,
                     "with planes: add their light up in eight bits, as graphics cards had to in "
                     "2007; needs --exposure EV100");
}

BeamSettings BeamOptions::parsed(const BeamSettings& otherwise) const {
    BeamSettings settings = method ? BeamSettings{} : otherwise;
    if (method == "auto" && (planes || tolerance)) {
        throw CLI::ValidationError("--beams", "auto chooses --planes and --tolerance itself");
    }
    if (method && method != "auto") {
        settings.method = valueIn(beamMethods(), *method).value();
    }
    settings.planes = planes.value_or(settings.planes);
    if (tolerance) {
        settings.tolerance = tolerance;
    }
    settings.spacingMetres = spacingMetres;
    settings.eightBitBlending = eightBit;
    if (!cells.empty()) {
        const PictureSize size = parseCells(cells);
        settings.cellsAcross = size.width;
        settings.cellsDown = size.height;
    }
    const bool isPlanes = settings.method == BeamMethod::kPlanes;
    if (!isPlanes && (spacingMetres || eightBit || !cells.empty())) {
        throw CLI::ValidationError("--beams",
                                   "--dt, --cells and --eight-bit belong to --beams planes");
    }
    if (tolerance && settings.method != BeamMethod::kAdaptive) {
        throw CLI::ValidationError("--tolerance", "belongs to --beams adaptive");
    }
    return settings;
}

std::optional<BeamGoal> BeamOptions::goal() const {
    if (method != "auto") {
        if (!budget.empty() || !error.empty()) {
            throw CLI::ValidationError("--beams", "--budget and --error belong to --beams auto");
        }
        return std::nullopt;
    }
    BeamGoal goal;
    if (!budget.empty()) {
        goal.budgetMs = parseWithUnit("--budget", budget, "ms", 0.01, kMaxBudgetMs,
                                      "a time of 0.01..600000 milliseconds such as 4ms");
    } else if (!error.empty()) {
        goal.errorPercent = parseWithUnit("--error", error, "%", kMinErrorPercent, 100.0,
                                          "an error of 0.001..100 percent such as 0.5%");
    }
    return goal;
}

}  // namespace ribalta
