// SweepRecord: one point of a sweep and what was measured there, as data, JSON and CSV.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "measure/statistics.h"
#include "render/frame_settings.h"

namespace ribalta {

/// What is drawn, apart from the scene's content: a record's identity together with that.
struct SweepPoint {
    std::string scene;   ///< the file as it was given
    std::string camera;  ///< its name in the file
    std::string label;   ///< of a preset's point, such as A-1; otherwise empty
    FrameSettings settings;

    /// "stage/front 1280x720": scene, camera, size and label, the same for all methods.
    std::string view() const;
    /// "clipped", with what else than its count of sheets tells its settings from others.
    std::string method() const;
    /// "stage/front/1280x720/clipped/24".
    std::string name() const;
};

struct PassSpread {
    std::string name;
    Spread cpuMs;
    Spread gpuMs;
};

/// How far a picture is from one reference.
struct SweepError {
    std::string against;                ///< "shadow-map" or "geometry"
    double beamsRelativeRmse = 0.0;     ///< of the beams' luminance alone; see LinearError
    double displayRmsePercent = 0.0;    ///< of the shown picture; see DisplayError
    double psnr = 0.0;                  ///< dB
    double flip = 0.0;                  ///< mean
    double referenceRelativeRms = 0.0;  ///< the reference's own estimated error
};

struct SweepRecord {
    enum class Status { kMeasured, kSkipped, kFailed };

    std::string key;  ///< of all that the result depends on
    SweepPoint point;
    Status status = Status::kFailed;
    std::string message;  ///< why it was skipped, failed or measured less often than asked
    int warmups = 0;
    int repeats = 0;
    double maxPointSeconds = 0.0;  ///< the limit that it was measured under
    Spread frameMs;                ///< wall time from planning to the last pixel
    std::vector<PassSpread> passes;
    std::uint64_t samples = 0;             ///< of light, an upper bound
    std::optional<std::uint64_t> peakRss;  ///< bytes of the process while it was measured
    std::uint64_t peakGl = 0;              ///< bytes of buffers and textures
    std::optional<double> ev100;           ///< at which errors are shown
    std::vector<SweepError> errors;
    std::string picture;     ///< file beside the results; empty: none
    std::string reference;   ///< shown, of errors.front()
    std::string difference;  ///< from errors.front()'s reference
    std::string frame;       ///< the frame itself at full size, where it was asked for

    double fps() const { return frameMs.median > 0.0 ? 1000.0 / frameMs.median : 0.0; }
    /// GPU time of the pass that draws beams; 0 without one.
    double beamsMs() const;
};

const char* name(SweepRecord::Status status);

nlohmann::json toJson(const SweepRecord& record);
/// Throws nlohmann::json::exception where it is not what toJson made.
SweepRecord recordFromJson(const nlohmann::json& json);

/// A header line and a line for each record, comma-separated (RFC 4180). Numbers have the digits
/// that the JSON has.
std::string toCsv(const std::vector<SweepRecord>& records);

}  // namespace ribalta
