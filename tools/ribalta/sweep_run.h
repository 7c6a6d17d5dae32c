// SweepRun: carries a sweep out, keeps its results on the disk as it goes, and goes on where an
// earlier run in the same folder was ended.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/progress.h"
#include "gl/context.h"
#include "measure/measure_point.h"
#include "measure/sweep_view.h"
#include "sweep_plan.h"

namespace ribalta {

struct SweepSettings {
    std::filesystem::path folder;
    MeasureSettings measure;
    std::vector<std::string> visibilities;  ///< of references: "shadow-map", "geometry"; or none
    double targetPercent = 0.5;             ///< error that the report compares times at
    bool fresh = false;                     ///< forget what was measured and drawn before
    bool frames = false;                    ///< keep every point's frame at full size
};

class SweepRun {
  public:
    /// Reads the folder's earlier results. Throws Error(kBadInput) where they are no sweep's,
    /// Error(kJobFailed) where the folder cannot be written.
    SweepRun(SweepPlan plan, SweepSettings settings, const Context& context);

    /// Measures what is not measured yet. sweep.json and sweep.csv are whole after every point,
    /// report.html after every view. Returns early where a signal asked for it, which is then
    /// returned, otherwise 0. Throws Error(kJobFailed) where results cannot be written; the files
    /// are then those of the point before.
    int run();

    /// Of this run's points, in the plan's order, those there are.
    std::vector<SweepRecord> records() const;
    std::size_t count(SweepRecord::Status status) const;
    std::size_t pointCount() const { return plan_.points.size(); }
    /// Points that an earlier run had measured.
    std::size_t keptCount() const { return kept_; }

  private:
    using Range = std::pair<std::size_t, std::size_t>;  ///< of points: first, past the last

    void readEarlier();
    std::string keyOf(const PlannedPoint& planned) const;
    bool isPending(std::size_t index) const;
    bool anyPending(const Range& range) const;
    /// The points after `first` for which `same` holds with it.
    Range rangeFrom(
        std::size_t first,
        const std::function<bool(const PlannedPoint&, const PlannedPoint&)>& same) const;
    void runScene(const Range& range);
    void runView(Renderer& renderer, const Range& range);
    SweepView makeView(Renderer& renderer, const PlannedPoint& planned);
    std::string writeReferencePicture(const SweepView& view, const std::string& key) const;
    void runPoint(Renderer& renderer, const SweepView& view, const std::string& reference,
                  std::size_t index);
    void keepFrame(Renderer& renderer, const PlannedPoint& planned, SweepRecord& record);
    void showLight(Renderer& renderer, const SweepView& view, const PlannedPoint& planned,
                   SweepRecord& record);
    void fail(const Range& range, const std::string& why);
    void finishPoint(std::size_t index, SweepRecord record);
    std::optional<double> expectedFrameSeconds(const SweepPoint& point) const;
    double secondsLeft() const;
    void writeResults() const;
    void writeReport() const;
    std::vector<SweepRecord> allRecords() const;

    SweepPlan plan_;
    SweepSettings settings_;
    nlohmann::json context_;
    std::string program_;
    std::string renderer_;
    std::vector<std::string> keys_;                    ///< by point
    std::vector<std::optional<SweepRecord>> records_;  ///< by point
    std::vector<SweepRecord> others_;                  ///< earlier ones that are not in the plan
    std::vector<bool> done_;  ///< by point: kept from before, or dealt with in this run
    std::size_t kept_ = 0;
    std::optional<Progress> progress_;
};

}  // namespace ribalta
