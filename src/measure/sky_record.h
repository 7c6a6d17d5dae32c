// SkyRecord: one model's picture from one viewpoint: what it takes and how far it is from the
// truth, as data, JSON and CSV; and both beside the thesis's figures.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "measure/pinheiro2014.h"
#include "measure/rgb_picture.h"
#include "measure/statistics.h"

namespace ribalta {

/// How far a picture is from a reference; the first three relative, of radiance, over the channels
/// of pixels that are brighter than 1e-6 of the sun's illuminance and do not see its disc.
struct SkyPictureError {
    double median = 0.0;
    double p95 = 0.0;
    double largest = 0.0;
    double displayRmsePercent = 0.0;  ///< see DisplayError
    double psnr = 0.0;                ///< dB
    double flip = 0.0;                ///< mean
    double referenceRms = 0.0;        ///< the reference's own estimated error, relative
};
/// At the view's exposure; in cd/m2 from the view's camera.
SkyPictureError skyPictureError(const RgbPicture& drawn, const RgbPicture& reference,
                                const SkyViewpoint& view, const SkyOverScene& truth);

struct SkyRecord {
    std::string view;
    std::string row;
    int width = 0;
    int height = 0;
    std::uint64_t bytes = 0;        ///< of buffers and textures that the sky keeps
    std::uint64_t peakBytes = 0;    ///< with those that only making its tables needs
    double tablesMs = 0.0;          ///< from nothing, programs included
    double tablesCpuSeconds = 0.0;  ///< of all threads, for that and the first picture
    Spread skyMs;                   ///< the GPU's, of a picture when the tables are there
    Spread frameMs;
    int repeats = 0;
    std::string message;  ///< why it failed, or was measured less often than asked
    bool failed = false;
    SkyPictureError own;    ///< against the same orders and air
    SkyPictureError whole;  ///< against every order with haze
    std::string picture;    ///< files beside the results; empty: none
    std::string difference;
    std::string reference;

    std::string name() const;  ///< "sunset/auto/480x270"
};

nlohmann::json toJson(const SkyRecord& record);
/// A header line and a line a record (RFC 4180), with the digits that the JSON has.
std::string toCsv(const std::vector<SkyRecord>& records);

/// A line for each model, beside the thesis's: memory, times, errors over all viewpoints (medians
/// of the viewpoints' medians, the worst 95 %), as text in columns.
std::string skyTable(const std::vector<SkyRecord>& records);

/// A whole HTML file. `folder` holds the records' pictures.
std::string makeSkyReport(const nlohmann::json& context, const std::vector<SkyRecord>& records,
                          const std::filesystem::path& folder);

}  // namespace ribalta
