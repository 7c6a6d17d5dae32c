#include "sweep_sky.h"

#include <algorithm>
#include <ctime>
#include <optional>
#include <sstream>
#include <utility>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/log.h"
#include "base/progress.h"
#include "base/temporary_file.h"
#include "gl/counters.h"
#include "image/write_image.h"
#include "interrupts.h"
#include "measure/display_picture.h"
#include "measure/error_picture.h"
#include "measure/reference_cache.h"
#include "measure/scene_hash.h"
#include "measure/sweep_report.h"
#include "render/read_frame.h"
#include "sweep_context.h"

namespace ribalta {
namespace {

const char* const kSceneName = "pinheiro2014";

FrameSettings frameSettings(const PictureSize& size) {
    FrameSettings settings;
    settings.width = size.width;
    settings.height = size.height;
    settings.haze.scatteringPerMetre = 0.0;
    settings.ambientLux = 0.0;
    settings.display = false;
    return settings;
}

RgbPicture readColors(const Renderer& renderer) {
    const Place place{"the drawn frame", ""};
    RgbPicture picture =
        pickLayer(readFrame(renderer.lastPlan(), renderer.targets(), {}), "", place);
    refuseNonFinite(picture, place);
    return picture;
}

class SkySweep {
  public:
    SkySweep(SkySweepSettings settings, const Context& context)
        : settings_(std::move(settings)),
          context_(sweepContext(context,
                                std::string(RIBALTA_VERSION) + " " + hashProgram().substr(0, 8))) {
        makeFolder(settings_.folder / "pictures");
        makeFolder(settings_.folder / "references");
        for (const char* file : {"sweep.json", "sweep.csv", "report.html"}) {
            const TemporaryFile probe(settings_.folder / file);
        }
        if (settings_.fresh) {
            std::error_code ignored;
            for (const auto& entry :
                 std::filesystem::directory_iterator(settings_.folder / "references", ignored)) {
                if (entry.path().extension() == ".exr") {
                    std::filesystem::remove(entry.path(), ignored);
                }
            }
        }
        settings_.measure.interrupted = [] { return InterruptWatch::noted() != 0; };
    }

    std::vector<SkyRecord> run() {
        progress_.emplace("skies", settings_.rows.size() * skyViewpoints().size());
        const InterruptWatch watch;
        try {
            for (const SkyRow& row : settings_.rows) {
                runRow(row);
                writeResults();
            }
        } catch (const Interrupted&) {
            // Models that were measured are on the disk.
        }
        progress_.reset();
        writeResults();
        return records_;
    }

  private:
    /// What a model's tables take, which all viewpoints share.
    void makeTables(const SkyRow& row, Renderer& renderer, SkyRecord& record) const {
        FrameSettings settings = frameSettings(settings_.size);
        const SkyViewpoint& view = skyViewpoints().front();
        renderer.draw(cameraOf(view), settings);
        renderer.takeTimes();
        const std::uint64_t without = glCounters().bytesAllocated;
        glCounters().peakBytes = without;
        settings.sky = drawingOf(view, row);
        const std::clock_t start = std::clock();
        renderer.draw(cameraOf(view), settings);
        for (const PassTime& pass : renderer.takeTimes()) {
            if (pass.name == "sky_tables") {
                record.tablesMs = std::max(pass.cpuMs, pass.gpuMs);
            }
        }
        record.tablesCpuSeconds = double(std::clock() - start) / CLOCKS_PER_SEC;
        record.bytes = glCounters().bytesAllocated - without;
        record.peakBytes = glCounters().peakBytes - without;
    }

    void runRow(const SkyRow& row) {
        SkyRecord shared;
        shared.row = row.name;
        shared.width = settings_.size.width;
        shared.height = settings_.size.height;
        const Scene none;
        std::optional<Renderer> renderer;
        try {
            renderer.emplace(none);
            makeTables(row, *renderer, shared);
        } catch (const std::exception& error) {
            shared.failed = true;
            shared.message = oneLine(error.what());
            logWarning(row.name + ": failed: " + shared.message);
        }
        for (const SkyViewpoint& view : skyViewpoints()) {
            SkyRecord record = shared;
            record.view = view.name;
            if (!record.failed) {
                runView(row, view, *renderer, record);
            }
            records_.push_back(std::move(record));
            progress_->step();
        }
    }

    void runView(const SkyRow& row, const SkyViewpoint& view, Renderer& renderer,
                 SkyRecord& record) {
        SweepRecord times;
        times.point.settings = frameSettings(settings_.size);
        times.point.settings.sky = drawingOf(view, row);
        measureTimes(renderer, cameraOf(view), settings_.measure, std::nullopt, times);
        record.frameMs = times.frameMs;
        record.repeats = times.repeats;
        record.message = times.message;
        for (const PassSpread& pass : times.passes) {
            if (pass.name == "sky") {
                record.skyMs = pass.gpuMs;
            }
        }
        const RgbPicture drawn = readColors(renderer);
        const SkyOverScene own = truthOf(view, row, false);
        const SkyOverScene whole = truthOf(view, row, true);
        const KeptReference right = referenceOf(view, own);
        const KeptReference all = referenceOf(view, whole);
        record.own = skyPictureError(drawn, right.picture, view, own);
        record.own.referenceRms = right.facts.skyError.rms;
        record.whole = skyPictureError(drawn, all.picture, view, whole);
        record.whole.referenceRms = all.facts.skyError.rms;
        writePictures(view, drawn, right.picture, all.picture, record);
        logVerbose(record.name() + ": " + std::to_string(record.skyMs.median) + " ms, off by " +
                   std::to_string(100.0 * record.own.median) + " %");
    }

    KeptReference referenceOf(const SkyViewpoint& view, const SkyOverScene& truth) {
        ReferenceSettings settings;
        settings.camera = cameraOf(view);
        settings.width = settings_.size.width;
        settings.height = settings_.size.height;
        settings.haze.scatteringPerMetre = 0.0;
        settings.ambientLux = 0.0;
        settings.sky = truth;
        settings.skyTables = &tables_;
        return obtainReferencePicture(settings_.folder / "references", Scene(), kSceneName, "",
                                      settings);
    }

    void writePictures(const SkyViewpoint& view, const RgbPicture& drawn, const RgbPicture& right,
                       const RgbPicture& all, SkyRecord& record) const {
        const auto write = [&](const std::string& name, const BytePicture& picture) {
            writePng(settings_.folder / name, picture.width, picture.height, picture.rgb);
            return name;
        };
        const std::string stem = "pictures/" + record.view + "-" + record.row;
        const RgbPicture shown = displayPicture(drawn, view.ev100);
        record.picture = write(stem + ".png", smallPicture(shown, kReportPictureWidth));
        record.difference = write(stem + "-difference.png",
                                  errorPicture(shown, displayPicture(right, view.ev100),
                                               kReportDifferencePercent, kReportPictureWidth));
        record.reference =
            write("pictures/" + record.view + "-reference.png",
                  smallPicture(displayPicture(all, view.ev100), kReportPictureWidth));
    }

    void writeResults() const {
        nlohmann::json list = nlohmann::json::array();
        for (const SkyRecord& record : records_) {
            list.push_back(toJson(record));
        }
        const nlohmann::json json = {{"context", context_}, {"benchmarks", list}};
        writeFileAtomically(settings_.folder / "sweep.json", json.dump(1) + "\n");
        writeFileAtomically(settings_.folder / "sweep.csv", toCsv(records_));
        writeFileAtomically(settings_.folder / "report.html",
                            makeSkyReport(context_, records_, settings_.folder));
    }

    SkySweepSettings settings_;
    nlohmann::json context_;
    std::vector<SkyRecord> records_;
    SkyTableStore tables_;
    std::optional<Progress> progress_;
};

}  // namespace

std::vector<SkyRow> parseSkyRows(const std::string& text) {
    if (text == "all") {
        return skyRows();
    }
    std::vector<SkyRow> rows;
    std::istringstream names(text);
    std::string name;
    while (std::getline(names, name, ',')) {
        const auto is = [&](const SkyRow& row) { return row.name == name; };
        const auto found = std::find_if(skyRows().begin(), skyRows().end(), is);
        if (found == skyRows().end()) {
            std::string known;
            for (const SkyRow& row : skyRows()) {
                known += ", ";
                known += row.name;
            }
            throw CLI::ValidationError("--sky",
                                       "'" + name + "' is none of the models: all" + known);
        }
        if (std::none_of(rows.begin(), rows.end(), is)) {
            rows.push_back(*found);
        }
    }
    if (rows.empty()) {
        throw CLI::ValidationError("--sky", "names no model; leave it out for all");
    }
    return rows;
}

std::vector<SkyRecord> sweepSkies(const SkySweepSettings& settings, const Context& context) {
    return SkySweep(settings, context).run();
}

}  // namespace ribalta
