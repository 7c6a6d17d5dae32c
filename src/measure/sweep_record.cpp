#include "measure/sweep_record.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <utility>

#include <nlohmann/json.hpp>

#include "measure/csv_field.h"
#include "measure/json_numbers.h"

namespace ribalta {
namespace {

using Json = nlohmann::json;

std::string sizeText(const FrameSettings& settings) {
    return std::to_string(settings.width) + "x" + std::to_string(settings.height);
}

std::string fourDigits(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

template <typename Value>
Json valueOrNull(const std::optional<Value>& value) {
    return value ? Json(*value) : Json();
}

template <typename Value>
std::optional<Value> valueIfAny(const Json& json) {
    return json.is_null() ? std::nullopt : std::optional<Value>(json.get<Value>());
}

Json settingsToJson(const FrameSettings& settings) {
    const BeamSettings& beams = settings.beams;
    const Haze& haze = settings.haze;
    return {{"width", settings.width},
            {"height", settings.height},
            {"beams", std::string(name(beams.method))},
            {"planes", beams.planes},
            {"cells", Json::array({beams.cellsAcross, beams.cellsDown})},
            {"dt_m", valueOrNull(beams.spacingMetres)},
            {"eight_bit", beams.eightBitBlending},
            {"tolerance", valueOrNull(std::optional<double>(beams.tolerance))},
            {"scattering_per_m", haze.scatteringPerMetre},
            {"absorption_per_m", haze.absorptionPerMetre},
            {"phase", int(haze.phase.kind)},
            {"phase_g", haze.phase.g},
            {"phase_k", haze.phase.k},
            {"ambient_lux", settings.ambientLux},
            {"ev100", valueOrNull(settings.ev100)},
            {"tone_curve", std::string(name(settings.toneCurve))}};
}

FrameSettings settingsFromJson(const Json& json) {
    FrameSettings settings;
    settings.width = json.at("width");
    settings.height = json.at("height");
    settings.beams.method = valueIn(beamMethods(), json.at("beams").get<std::string>()).value();
    settings.beams.planes = json.at("planes");
    settings.beams.cellsAcross = json.at("cells").at(0);
    settings.beams.cellsDown = json.at("cells").at(1);
    settings.beams.spacingMetres = valueIfAny<double>(json.at("dt_m"));
    settings.beams.eightBitBlending = json.at("eight_bit");
    if (!json.at("tolerance").is_null()) {
        settings.beams.tolerance = json.at("tolerance").get<double>();
    }
    settings.haze.scatteringPerMetre = json.at("scattering_per_m");
    settings.haze.absorptionPerMetre = json.at("absorption_per_m");
    settings.haze.phase.kind = PhaseFunction::Kind(json.at("phase").get<int>());
    settings.haze.phase.g = json.at("phase_g");
    settings.haze.phase.k = json.at("phase_k");
    settings.ambientLux = json.at("ambient_lux");
    settings.ev100 = valueIfAny<double>(json.at("ev100"));
    settings.toneCurve = valueIn(toneCurves(), json.at("tone_curve").get<std::string>()).value();
    return settings;
}

Json spreadToJson(const Spread& spread) {
    return {{"median", spread.median}, {"iqr", spread.iqr}};
}

Spread spreadFromJson(const Json& json) {
    return {json.at("median"), json.at("iqr")};
}

Json errorToJson(const SweepError& error) {
    return {{"against", error.against},
            {"beams_relative_rmse", finiteOrNull(error.beamsRelativeRmse)},
            {"display_rmse_percent", error.displayRmsePercent},
            {"psnr_db", finiteOrNull(error.psnr)},
            {"flip_mean", error.flip},
            {"reference_relative_rms", error.referenceRelativeRms}};
}

SweepError errorFromJson(const Json& json) {
    return {json.at("against"),
            infiniteIfNull(json.at("beams_relative_rmse")),
            json.at("display_rmse_percent"),
            infiniteIfNull(json.at("psnr_db")),
            json.at("flip_mean"),
            json.at("reference_relative_rms")};
}

SweepRecord::Status statusNamed(const std::string& wanted) {
    for (const auto status : {SweepRecord::Status::kMeasured, SweepRecord::Status::kSkipped}) {
        if (wanted == name(status)) {
            return status;
        }
    }
    return SweepRecord::Status::kFailed;
}

// Columns that every record has, by where its JSON has them.
constexpr std::pair<const char*, const char*> kSweepColumns[] = {
    {"name", "/name"},
    {"scene", "/scene"},
    {"camera", "/camera"},
    {"label", "/label"},
    {"width", "/settings/width"},
    {"height", "/settings/height"},
    {"beams", "/settings/beams"},
    {"method", "/method"},
    {"planes", "/settings/planes"},
    {"scattering_per_m", "/settings/scattering_per_m"},
    {"absorption_per_m", "/settings/absorption_per_m"},
    {"status", "/status"},
    {"message", "/message"},
    {"warmups", "/warmups"},
    {"repeats", "/repetitions"},
    {"fps", "/fps"},
    {"frame_ms", "/frame_ms/median"},
    {"frame_ms_iqr", "/frame_ms/iqr"},
    {"samples", "/samples"},
    {"peak_rss_bytes", "/peak_rss_bytes"},
    {"peak_gl_bytes", "/peak_gl_bytes"},
    {"ev100", "/ev100"},
};

constexpr const char* kSweepErrorColumns[] = {"beams_relative_rmse", "display_rmse_percent",
                                              "psnr_db", "flip_mean", "reference_relative_rms"};

void addOnce(std::vector<std::string>& names, const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        names.push_back(name);
    }
}

// The element of a JSON list whose `member` is `value`, or null.
Json elementWith(const Json& list, const char* member, const std::string& value) {
    for (const Json& element : list) {
        if (element.at(member) == value) {
            return element;
        }
    }
    return {};
}

}  // namespace

std::string SweepPoint::view() const {
    return std::filesystem::path(scene).stem().string() + "/" + camera + " " + sizeText(settings) +
           (label.empty() ? "" : " " + label);
}

std::string SweepPoint::method() const {
    std::string text(ribalta::name(settings.beams.method));
    if (settings.beams.cellsAcross > 0) {
        char cells[48];
        std::snprintf(cells, sizeof cells, " %dx%d cells", settings.beams.cellsAcross,
                      settings.beams.cellsDown);
        text += cells;
    }
    const std::optional<double> tolerance = settings.beams.tolerance;
    if (tolerance && tolerance != std::optional<double>(BeamSettings{}.tolerance)) {
        text += " tolerance " + fourDigits(*tolerance);
    }
    if (settings.beams.eightBitBlending) {
        text += " in 8 bits";
    }
    if (settings.beams.spacingMetres) {
        text += " dt " + fourDigits(*settings.beams.spacingMetres) + " m";
    }
    return text;
}

std::string SweepPoint::name() const {
    return std::filesystem::path(scene).stem().string() + "/" + camera + "/" + sizeText(settings) +
           "/" + (label.empty() ? "" : label + "/") + method() + "/" +
           std::to_string(settings.beams.planes);
}

double SweepRecord::beamsMs() const {
    for (const PassSpread& pass : passes) {
        if (pass.name == "beams") {
            return pass.gpuMs.median;
        }
    }
    return 0.0;
}

const char* name(SweepRecord::Status status) {
    switch (status) {
        case SweepRecord::Status::kMeasured:
            return "measured";
        case SweepRecord::Status::kSkipped:
            return "skipped";
        case SweepRecord::Status::kFailed:
            break;
    }
    return "failed";
}

Json toJson(const SweepRecord& record) {
    Json passes = Json::array();
    double cpuMs = 0.0;
    for (const PassSpread& pass : record.passes) {
        passes.push_back({{"name", pass.name},
                          {"cpu_ms", spreadToJson(pass.cpuMs)},
                          {"gpu_ms", spreadToJson(pass.gpuMs)}});
        cpuMs += pass.cpuMs.median;
    }
    Json errors = Json::array();
    for (const SweepError& error : record.errors) {
        errors.push_back(errorToJson(error));
    }
    // The first members are Google Benchmark's own.
    return {{"name", record.point.name()},
            {"run_name", record.point.name()},
            {"run_type", "aggregate"},
            {"aggregate_name", "median"},
            {"repetitions", record.repeats},
            {"iterations", 1},
            {"real_time", record.frameMs.median},
            {"cpu_time", cpuMs},
            {"time_unit", "ms"},
            {"key", record.key},
            {"scene", record.point.scene},
            {"camera", record.point.camera},
            {"label", record.point.label},
            {"view", record.point.view()},
            {"method", record.point.method()},
            {"settings", settingsToJson(record.point.settings)},
            {"status", name(record.status)},
            {"message", record.message},
            {"warmups", record.warmups},
            {"max_point_seconds", record.maxPointSeconds},
            {"fps", record.fps()},
            {"frame_ms", spreadToJson(record.frameMs)},
            {"passes", passes},
            {"samples", record.samples},
            {"peak_rss_bytes", valueOrNull(record.peakRss)},
            {"peak_gl_bytes", record.peakGl},
            {"ev100", valueOrNull(record.ev100)},
            {"errors", errors},
            {"picture", record.picture},
            {"reference", record.reference},
            {"difference", record.difference},
            {"frame", record.frame}};
}

SweepRecord recordFromJson(const Json& json) {
    SweepRecord record;
    record.key = json.at("key");
    record.point.scene = json.at("scene");
    record.point.camera = json.at("camera");
    record.point.label = json.at("label");
    record.point.settings = settingsFromJson(json.at("settings"));
    record.status = statusNamed(json.at("status"));
    record.message = json.at("message");
    record.warmups = json.at("warmups");
    record.repeats = json.at("repetitions");
    record.maxPointSeconds = json.at("max_point_seconds");
    record.frameMs = spreadFromJson(json.at("frame_ms"));
    for (const Json& pass : json.at("passes")) {
        record.passes.push_back({pass.at("name"), spreadFromJson(pass.at("cpu_ms")),
                                 spreadFromJson(pass.at("gpu_ms"))});
    }
    record.samples = json.at("samples");
    record.peakRss = valueIfAny<std::uint64_t>(json.at("peak_rss_bytes"));
    record.peakGl = json.at("peak_gl_bytes");
    record.ev100 = valueIfAny<double>(json.at("ev100"));
    for (const Json& error : json.at("errors")) {
        record.errors.push_back(errorFromJson(error));
    }
    record.picture = json.at("picture");
    record.reference = json.at("reference");
    record.difference = json.at("difference");
    record.frame = json.at("frame");
    return record;
}

std::string toCsv(const std::vector<SweepRecord>& records) {
    std::vector<std::string> passes;
    std::vector<std::string> references;
    for (const SweepRecord& record : records) {
        for (const PassSpread& pass : record.passes) {
            addOnce(passes, pass.name);
        }
        for (const SweepError& error : record.errors) {
            addOnce(references, error.against);
        }
    }
    std::string csv;
    for (const auto& [column, where] : kSweepColumns) {
        csv += csv.empty() ? "" : ",";
        csv += column;
    }
    for (const std::string& pass : passes) {
        for (const char* what : {"_cpu_ms", "_cpu_ms_iqr", "_gpu_ms", "_gpu_ms_iqr"}) {
            csv += ',';
            csv += csvText(pass + what);
        }
    }
    for (const std::string& reference : references) {
        for (const char* column : kSweepErrorColumns) {
            csv += ',';
            csv += csvText(std::string(column) + "@" + reference);
        }
    }
    csv += "\n";
    for (const SweepRecord& record : records) {
        const Json json = toJson(record);
        std::string line;
        for (const auto& [column, where] : kSweepColumns) {
            line += line.empty() ? "" : ",";
            line += csvField(json.at(Json::json_pointer(where)));
        }
        for (const std::string& pass : passes) {
            const Json times = elementWith(json.at("passes"), "name", pass);
            for (const char* where :
                 {"/cpu_ms/median", "/cpu_ms/iqr", "/gpu_ms/median", "/gpu_ms/iqr"}) {
                line += ',';
                line += times.is_null() ? "" : csvField(times.at(Json::json_pointer(where)));
            }
        }
        for (const std::string& reference : references) {
            const Json error = elementWith(json.at("errors"), "against", reference);
            for (const char* column : kSweepErrorColumns) {
                line += ',';
                line += error.is_null() ? "" : csvField(error.at(column));
            }
        }
        csv += line + "\n";
    }
    return csv;
}

}  // namespace ribalta
