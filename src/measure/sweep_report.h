// SweepReport: a sweep as one page that a browser shows without a network.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "measure/sweep_record.h"

namespace ribalta {

/// How long a method takes to reach an error in a view.
struct TimeToError {
    std::string view;
    std::string method;            ///< its name with its settings
    bool isBaseline = false;       ///< of the first of all methods
    std::optional<double> timeMs;  ///< none: no point reaches it
    double leastError = 0.0;       ///< the best that was measured, in %
    double longestMs = 0.0;        ///< of the measured points
};

/// For every view and, in it, every method with errors, in the records' order; time is the GPU's
/// for the beams, error the tone-mapped RMSE against the first reference.
std::vector<TimeToError> timesToError(const std::vector<SweepRecord>& records,
                                      double targetPercent);

/// A whole HTML file. `folder` holds the records' pictures; one that is missing is left out.
/// `context` is shown as it is, name by name.
std::string makeReport(const nlohmann::json& context, const std::vector<SweepRecord>& records,
                       const std::filesystem::path& folder, double targetPercent);

/// An error that is white in difference pictures, in % of full scale.
inline constexpr double kReportDifferencePercent = 5.0;
/// Pixels that its pictures are wide at most.
inline constexpr int kReportPictureWidth = 480;

}  // namespace ribalta
