#include "measure/sky_record.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include <nlohmann/json.hpp>

#include "measure/csv_field.h"
#include "measure/display_picture.h"
#include "measure/json_numbers.h"
#include "measure/picture_error.h"

namespace ribalta {
namespace {

using Json = nlohmann::json;

constexpr double kDarkest = 1e-6;  // of the sun's illuminance

Json toJson(const SkyPictureError& error) {
    return {{"relative_median", error.median},
            {"relative_p95", error.p95},
            {"relative_largest", error.largest},
            {"display_rmse_percent", error.displayRmsePercent},
            {"psnr_db", finiteOrNull(error.psnr)},
            {"flip_mean", error.flip},
            {"reference_relative_rms", error.referenceRms}};
}

Json toJson(const Spread& spread) {
    return {{"median", spread.median}, {"iqr", spread.iqr}};
}

const SkyRow* rowNamed(const std::string& name) {
    for (const SkyRow& row : skyRows()) {
        if (row.name == name) {
            return &row;
        }
    }
    return nullptr;
}

constexpr std::pair<const char*, const char*> kSkyColumns[] = {
    {"name", "/name"},
    {"view", "/view"},
    {"model", "/model"},
    {"width", "/width"},
    {"height", "/height"},
    {"status", "/status"},
    {"message", "/message"},
    {"repeats", "/repetitions"},
    {"memory_bytes", "/memory_bytes"},
    {"peak_bytes", "/peak_bytes"},
    {"tables_ms", "/tables_ms"},
    {"tables_cpu_s", "/tables_cpu_s"},
    {"sky_gpu_ms", "/sky_gpu_ms/median"},
    {"sky_gpu_ms_iqr", "/sky_gpu_ms/iqr"},
    {"frame_ms", "/frame_ms/median"},
    {"frame_ms_iqr", "/frame_ms/iqr"},
    {"thesis_kb", "/thesis/memory_kb"},
    {"thesis_ms", "/thesis/ms"},
};
constexpr const char* kSkyErrorColumns[] = {
    "relative_median", "relative_p95", "relative_largest",      "display_rmse_percent",
    "psnr_db",         "flip_mean",    "reference_relative_rms"};

std::string line(const char* format, auto... values) {
    char text[200];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

}  // namespace

SkyPictureError skyPictureError(const RgbPicture& drawn, const RgbPicture& reference,
                                const SkyViewpoint& view, const SkyOverScene& truth) {
    const Camera camera = cameraOf(view);
    const glm::dvec2 half = viewHalfExtent(camera, drawn.width, drawn.height);
    // A pixel's half diagonal more than the disc's radius.
    const double nearest = std::cos(truth.air.sunAngularRadius + 2.0 * half.y / drawn.height);
    std::vector<double> errors;
    for (int y = 0; y < drawn.height; ++y) {
        for (int x = 0; x < drawn.width; ++x) {
            const glm::dvec3 direction = glm::normalize(
                camera.frame.forward() +
                ((2.0 * x + 1.0) / drawn.width - 1.0) * half.x * camera.frame.right() +
                (1.0 - (2.0 * y + 1.0) / drawn.height) * half.y * camera.frame.up());
            if (glm::dot(direction, truth.towardsSun) > nearest) {
                continue;
            }
            for (int c = 0; c < 3; ++c) {
                const auto right = double(reference.at(x, y)[c]);
                if (right > kDarkest * truth.air.sunIlluminanceLux[c]) {
                    errors.push_back(std::abs(double(drawn.at(x, y)[c]) / right - 1.0));
                }
            }
        }
    }
    const DisplayError shown =
        displayError(displayPicture(drawn, view.ev100), displayPicture(reference, view.ev100));
    SkyPictureError error;
    error.median = quantile(errors, 0.5);
    error.p95 = quantile(errors, 0.95);
    error.largest = quantile(errors, 1.0);
    error.displayRmsePercent = shown.rmsePercent;
    error.psnr = shown.psnr;
    error.flip = shown.flipMean;
    return error;
}

std::string SkyRecord::name() const {
    return view + "/" + row + "/" + std::to_string(width) + "x" + std::to_string(height);
}

Json toJson(const SkyRecord& record) {
    const SkyRow* const row = rowNamed(record.row);
    Json thesis = {{"memory_kb", Json()}, {"ms", Json()}};
    if (row != nullptr && row->thesis) {
        thesis = {{"memory_kb", row->thesis->kilobytes}, {"ms", row->thesis->ms}};
    }
    // The first members are Google Benchmark's own.
    return {{"name", record.name()},
            {"run_name", record.name()},
            {"run_type", "aggregate"},
            {"aggregate_name", "median"},
            {"repetitions", record.repeats},
            {"iterations", 1},
            {"real_time", record.frameMs.median},
            {"time_unit", "ms"},
            {"view", record.view},
            {"model", record.row},
            {"width", record.width},
            {"height", record.height},
            {"status", record.failed ? "failed" : "measured"},
            {"message", record.message},
            {"memory_bytes", record.bytes},
            {"peak_bytes", record.peakBytes},
            {"tables_ms", record.tablesMs},
            {"tables_cpu_s", record.tablesCpuSeconds},
            {"sky_gpu_ms", toJson(record.skyMs)},
            {"frame_ms", toJson(record.frameMs)},
            {"thesis", thesis},
            {"own", toJson(record.own)},
            {"whole", toJson(record.whole)},
            {"picture", record.picture},
            {"reference", record.reference},
            {"difference", record.difference}};
}

std::string toCsv(const std::vector<SkyRecord>& records) {
    std::string csv;
    for (const auto& [column, where] : kSkyColumns) {
        csv += csv.empty() ? "" : ",";
        csv += column;
    }
    for (const char* against : {"own", "whole"}) {
        for (const char* column : kSkyErrorColumns) {
            csv += ',';
            csv += column;
            csv += '@';
            csv += against;
        }
    }
    csv += "\n";
    for (const SkyRecord& record : records) {
        const Json json = toJson(record);
        std::string text;
        for (const auto& [column, where] : kSkyColumns) {
            text += text.empty() ? "" : ",";
            text += csvField(json.at(Json::json_pointer(where)));
        }
        for (const char* against : {"own", "whole"}) {
            for (const char* column : kSkyErrorColumns) {
                text += ',';
                text += csvField(json.at(against).at(column));
            }
        }
        csv += text;
        csv += '\n';
    }
    return csv;
}

std::string skyTable(const std::vector<SkyRecord>& records) {
    std::string text =
        "Pinheiro 2014 on a GeForce GTX 560, and here: memory, making tables, drawing (median of "
        "the views), error of radiance\nagainst the same orders and air (median of the views' "
        "medians; largest 95 % of a view) and against the whole truth\n";
    text +=
        line("%-18s %9s %10s  %9s %10s %9s %9s  %9s %9s %9s\n", "model", "thesis KB", "thesis ms",
             "KB", "tables ms", "CPU s", "sky ms", "own p50", "own p95", "whole p50");
    for (const SkyRow& row : skyRows()) {
        std::vector<double> sky;
        std::vector<double> medians;
        std::vector<double> wholes;
        double p95 = 0.0;
        const SkyRecord* last = nullptr;
        for (const SkyRecord& record : records) {
            if (record.row == row.name && !record.failed) {
                last = &record;
                sky.push_back(record.skyMs.median);
                medians.push_back(record.own.median);
                wholes.push_back(record.whole.median);
                p95 = std::max(p95, record.own.p95);
            }
        }
        if (last == nullptr) {
            continue;
        }
        text +=
            line("%-18s %9s %10s  %9.0f %10.1f %9.2f %9.2f  %8.3f%% %8.2f%% %8.2f%%\n",
                 row.name.c_str(), row.thesis ? line("%.0f", row.thesis->kilobytes).c_str() : "",
                 row.thesis ? line("%g", row.thesis->ms).c_str() : "", double(last->bytes) / 1024.0,
                 last->tablesMs, last->tablesCpuSeconds, median(sky), 100.0 * median(medians),
                 100.0 * p95, 100.0 * median(wholes));
    }
    return text;
}

}  // namespace ribalta
