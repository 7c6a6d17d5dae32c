// The sweep over skies: every model from every viewpoint of the thesis.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gl/context.h"
#include "measure/measure_point.h"
#include "measure/sky_record.h"
#include "options.h"

namespace ribalta {

struct SkySweepSettings {
    std::filesystem::path folder;
    PictureSize size;
    std::vector<SkyRow> rows;
    MeasureSettings measure;
    bool fresh = false;  ///< forget references that were drawn before
};

/// Rows of "all" or of names by comma. Throws CLI::ValidationError that lists them.
std::vector<SkyRow> parseSkyRows(const std::string& text);

/// Measures and draws them. sweep.json and sweep.csv are whole after every model, report.html too.
/// Returns early where a signal asked for it. Throws Error(kJobFailed) where the folder cannot be
/// written.
std::vector<SkyRecord> sweepSkies(const SkySweepSettings& settings, const Context& context);

}  // namespace ribalta
