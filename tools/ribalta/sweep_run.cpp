#include "sweep_run.h"

#include <algorithm>
#include <utility>

#include "base/content_hash.h"
#include "base/error.h"
#include "base/log.h"
#include "base/read_file.h"
#include "base/temporary_file.h"
#include "image/write_image.h"
#include "interrupts.h"
#include "measure/drawn_frame.h"
#include "measure/error_picture.h"
#include "measure/reference_cache.h"
#include "measure/scene_hash.h"
#include "measure/sweep_report.h"
#include "reference/reference_file.h"
#include "render/read_frame.h"
#include "sweep_context.h"

namespace ribalta {
namespace {

using Json = nlohmann::json;

std::string fileName(const SweepPoint& point) {
    return std::filesystem::path(point.scene).filename().string();
}

ReferenceSettings referenceSettings(const PlannedPoint& planned) {
    ReferenceSettings settings;
    settings.camera = planned.camera;
    settings.width = planned.point.settings.width;
    settings.height = planned.point.settings.height;
    settings.haze = planned.point.settings.haze;
    settings.ambientLux = planned.point.settings.ambientLux;
    return settings;
}

bool sameScene(const PlannedPoint& a, const PlannedPoint& b) {
    return a.scene == b.scene;
}

bool sameView(const PlannedPoint& a, const PlannedPoint& b) {
    return a.scene == b.scene && a.point.view() == b.point.view();
}

void tellOfPoint(const SweepRecord& record) {
    const std::string point = record.point.name() + ": ";
    if (record.status == SweepRecord::Status::kFailed) {
        logWarning(point + name(record.status) + ": " + record.message);
    } else if (!record.message.empty() || record.status != SweepRecord::Status::kMeasured) {
        logVerbose(point + name(record.status) + ": " + record.message);
    } else {
        char times[96];
        std::snprintf(times, sizeof times, "%.2f ms, beams %.2f ms", record.frameMs.median,
                      record.beamsMs());
        logVerbose(point + times);
    }
}

}  // namespace

SweepRun::SweepRun(SweepPlan plan, SweepSettings settings, const Context& context)
    : plan_(std::move(plan)), settings_(std::move(settings)), renderer_(context.renderer()) {
    program_ = std::string(RIBALTA_VERSION) + " " + hashProgram().substr(0, 8);
    context_ = sweepContext(context, program_);
    settings_.measure.interrupted = [] { return InterruptWatch::noted() != 0; };
    records_.resize(plan_.points.size());
    done_.resize(plan_.points.size());
    for (const PlannedPoint& planned : plan_.points) {
        keys_.push_back(keyOf(planned));
    }
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
    } else {
        readEarlier();
    }
}

std::string SweepRun::keyOf(const PlannedPoint& planned) const {
    SweepRecord record;
    record.point = planned.point;
    const Json json = toJson(record);
    ContentHash hash;
    hash.add(program_);
    hash.add(renderer_);
    hash.add(plan_.scenes[planned.scene].hash);
    hash.add(json.at("name").get<std::string>());
    hash.add(json.at("settings").dump());
    hash.add(describeReference("", referenceSettings(planned)).camera);
    hash.add(std::to_string(settings_.measure.warmups));
    hash.add(std::to_string(settings_.measure.repeats));
    for (const std::string& visibility : settings_.visibilities) {
        hash.add(visibility);
    }
    hash.add(settings_.frames ? "frames" : "");
    return hash.text();
}

void SweepRun::readEarlier() {
    const std::filesystem::path file = settings_.folder / "sweep.json";
    if (!std::filesystem::exists(file)) {
        return;
    }
    const std::vector<std::byte> bytes = readFile(file);
    std::size_t dropped = 0;
    try {
        const Json json = Json::parse(reinterpret_cast<const char*>(bytes.data()),
                                      reinterpret_cast<const char*>(bytes.data()) + bytes.size());
        const bool sameProgram = json.at("context").at("program") == program_ &&
                                 json.at("context").at("renderer") == renderer_;
        for (const Json& each : json.at("benchmarks")) {
            if (!sameProgram) {
                ++dropped;
                continue;
            }
            SweepRecord record = recordFromJson(each);
            const auto place = std::find(keys_.begin(), keys_.end(), record.key);
            if (place == keys_.end()) {
                others_.push_back(std::move(record));
                continue;
            }
            // What failed is tried again, and so is what a smaller limit of time cut short.
            const auto index = std::size_t(place - keys_.begin());
            const bool isWhole = record.status == SweepRecord::Status::kMeasured &&
                                 (record.message.empty() ||
                                  record.maxPointSeconds >= settings_.measure.maxPointSeconds);
            done_[index] = isWhole;
            kept_ += isWhole ? 1 : 0;
            if (isWhole) {
                records_[index] = std::move(record);
            }
        }
    } catch (const std::exception& error) {
        throw Error(ErrorKind::kBadInput, {file.string(), ""},
                    std::string("holds no sweep that could go on (") + oneLine(error.what()) +
                        "); start over with --fresh, or give another folder");
    }
    if (dropped > 0) {
        logWarning(file.string() + ": " + std::to_string(dropped) +
                   " points were measured by another program or renderer and are dropped");
    }
}

bool SweepRun::isPending(std::size_t index) const {
    return !done_[index];
}

bool SweepRun::anyPending(const Range& range) const {
    for (std::size_t i = range.first; i < range.second; ++i) {
        if (isPending(i)) {
            return true;
        }
    }
    return false;
}

SweepRun::Range SweepRun::rangeFrom(
    std::size_t first,
    const std::function<bool(const PlannedPoint&, const PlannedPoint&)>& same) const {
    std::size_t end = first + 1;
    while (end < plan_.points.size() && same(plan_.points[first], plan_.points[end])) {
        ++end;
    }
    return {first, end};
}

int SweepRun::run() {
    progress_.emplace("measuring", plan_.points.size());
    for (std::size_t i = 0; i < kept_; ++i) {
        progress_->step();
    }
    try {
        for (std::size_t first = 0; first < plan_.points.size();) {
            const Range range = rangeFrom(first, sameScene);
            if (anyPending(range)) {
                runScene(range);
            }
            first = range.second;
        }
    } catch (const Interrupted&) {
        // What was measured is on the disk; the report follows.
    }
    progress_.reset();
    writeResults();
    writeReport();
    return InterruptWatch::noted();
}

void SweepRun::runScene(const Range& range) {
    const SweepScene& scene = plan_.scenes[plan_.points[range.first].scene];
    if (!scene.loaded) {
        fail(range, scene.wrong);
        return;
    }
    std::optional<Renderer> renderer;
    try {
        renderer.emplace(scene.loaded->scene);
    } catch (const std::exception& error) {
        fail(range, error.what());
        return;
    }
    for (std::size_t first = range.first; first < range.second;) {
        const Range view = rangeFrom(first, sameView);
        if (anyPending(view)) {
            runView(*renderer, view);
            writeReport();
        }
        first = view.second;
    }
}

void SweepRun::runView(Renderer& renderer, const Range& range) {
    std::optional<SweepView> view;
    try {
        view = makeView(renderer, plan_.points[range.first]);
    } catch (const std::exception& error) {
        fail(range, error.what());
        return;
    }
    const std::string reference = writeReferencePicture(*view, keys_[range.first]);
    const InterruptWatch watch;
    for (std::size_t i = range.first; i < range.second; ++i) {
        if (isPending(i)) {
            runPoint(renderer, *view, reference, i);
        }
    }
}

SweepView SweepRun::makeView(Renderer& renderer, const PlannedPoint& planned) {
    const SweepScene& scene = plan_.scenes[planned.scene];
    const ReferenceSettings settings = referenceSettings(planned);
    DrawnFrame drawn = drawForReference(renderer, scene.loaded->scene, settings);
    std::vector<ReferenceBeams> references;
    for (const std::string& visibility : settings_.visibilities) {
        ReferenceSettings wanted = settings;
        wanted.drawn = visibility == "shadow-map" ? &drawn : nullptr;
        references.push_back(obtainReference(settings_.folder / "references", scene.loaded->scene,
                                             fileName(planned.point), scene.hash, wanted));
    }
    return {{settings.width, settings.height, std::move(drawn.surfaces)},
            std::move(references),
            planned.point.settings.ev100,
            planned.point.settings.toneCurve};
}

// Named after the view's first point; empty without a reference.
std::string SweepRun::writeReferencePicture(const SweepView& view, const std::string& key) const {
    if (!view.hasReferences()) {
        return "";
    }
    std::string name = "pictures/";
    name += key + "-reference.png";
    const BytePicture picture = smallPicture(view.shownReference(), kReportPictureWidth);
    writePng(settings_.folder / name, picture.width, picture.height, picture.rgb);
    return name;
}

void SweepRun::runPoint(Renderer& renderer, const SweepView& view, const std::string& reference,
                        std::size_t index) {
    const PlannedPoint& planned = plan_.points[index];
    SweepRecord record;
    record.point = planned.point;
    progress_->expectLeft(secondsLeft());
    try {
        measureTimes(renderer, planned.camera, settings_.measure,
                     expectedFrameSeconds(planned.point), record);
    } catch (const std::exception& error) {
        record.status = SweepRecord::Status::kFailed;
        record.message = oneLine(error.what());
    }
    if (record.status == SweepRecord::Status::kMeasured) {
        record.reference = reference;
        showLight(renderer, view, planned, record);
        if (settings_.frames) {
            keepFrame(renderer, planned, record);
        }
    }
    tellOfPoint(record);
    finishPoint(index, std::move(record));
}

// As `ribalta render` would write it.
void SweepRun::keepFrame(Renderer& renderer, const PlannedPoint& planned, SweepRecord& record) {
    FrameSettings settings = planned.point.settings;
    settings.display = true;
    renderer.draw(planned.camera, settings);
    record.frame = "pictures/";
    record.frame += keys_[std::size_t(&planned - plan_.points.data())] + "-frame.png";
    writePng(settings_.folder / record.frame, settings.width, settings.height,
             readDisplay(renderer.targets()));
}

void SweepRun::showLight(Renderer& renderer, const SweepView& view, const PlannedPoint& planned,
                         SweepRecord& record) {
    const std::string& key = keys_[std::size_t(&planned - plan_.points.data())];
    BytePicture picture;
    BytePicture difference;
    try {
        const DrawnLight light = drawLight(renderer, planned.camera, planned.point.settings);
        refuseNonFinite(light.beams, {"the beams drawn", ""});
        const RgbPicture shown = view.show(light.beams);
        picture = smallPicture(shown, kReportPictureWidth);
        if (view.hasReferences()) {
            record.errors = view.errorsOf(light.beams, shown);
            record.ev100 = view.ev100();
            difference = errorPicture(shown, view.shownReference(), kReportDifferencePercent,
                                      kReportPictureWidth);
        }
    } catch (const std::exception& error) {
        record.status = SweepRecord::Status::kFailed;
        record.message = oneLine(error.what());
        return;
    }
    // Outside: a disk that is full is no fault of the point's.
    record.picture = "pictures/";
    record.picture += key + ".png";
    writePng(settings_.folder / record.picture, picture.width, picture.height, picture.rgb);
    if (!difference.rgb.empty()) {
        record.difference = "pictures/";
        record.difference += key + "-difference.png";
        writePng(settings_.folder / record.difference, difference.width, difference.height,
                 difference.rgb);
    }
}

// All points of a range, for one reason that is said once.
void SweepRun::fail(const Range& range, const std::string& why) {
    std::vector<std::size_t> pending;
    for (std::size_t i = range.first; i < range.second; ++i) {
        if (isPending(i)) {
            pending.push_back(i);
        }
    }
    if (pending.empty()) {
        return;
    }
    const std::string others =
        pending.size() > 1 ? " and " + std::to_string(pending.size() - 1) + " more" : "";
    logWarning(plan_.points[pending.front()].point.name() + others + ": failed: " + oneLine(why));
    for (const std::size_t i : pending) {
        SweepRecord record;
        record.point = plan_.points[i].point;
        record.message = oneLine(why);
        record.maxPointSeconds = settings_.measure.maxPointSeconds;
        finishPoint(i, std::move(record));
    }
}

void SweepRun::finishPoint(std::size_t index, SweepRecord record) {
    record.key = keys_[index];
    records_[index] = std::move(record);
    done_[index] = true;
    writeResults();
    progress_->step();
}

// From the nearest smaller count of sheets of the same method and view: the beams' time grows with
// the sheets, the rest stays.
std::optional<double> SweepRun::expectedFrameSeconds(const SweepPoint& point) const {
    const SweepRecord* nearest = nullptr;
    const auto planes = [](const SweepPoint& each) { return each.settings.beams.planes; };
    for (const std::optional<SweepRecord>& record : records_) {
        if (record && record->status == SweepRecord::Status::kMeasured &&
            record->point.view() == point.view() && record->point.method() == point.method() &&
            planes(record->point) < planes(point) &&
            (nearest == nullptr || planes(record->point) > planes(nearest->point))) {
            nearest = &*record;
        }
    }
    if (nearest == nullptr) {
        return std::nullopt;
    }
    const double beams = nearest->beamsMs();
    const double more = double(planes(point)) / planes(nearest->point) - 1.0;
    return 1e-3 * (nearest->frameMs.median + beams * more);
}

double SweepRun::secondsLeft() const {
    // Error measures and pictures take about as long as a few frames.
    const double frames = settings_.measure.warmups + settings_.measure.repeats + 3;
    double known = 0.0;
    std::size_t knownCount = 0;
    double left = 0.0;
    std::size_t unknownCount = 0;
    for (std::size_t i = 0; i < records_.size(); ++i) {
        if (records_[i] && records_[i]->status == SweepRecord::Status::kMeasured) {
            known += 1e-3 * records_[i]->frameMs.median;
            ++knownCount;
        }
        if (isPending(i)) {
            const auto seconds = expectedFrameSeconds(plan_.points[i].point);
            left +=
                seconds.value_or(0.0) > settings_.measure.maxPointSeconds
                    ? 0.0
                    : std::min(seconds.value_or(0.0) * frames, settings_.measure.maxPointSeconds);
            unknownCount += seconds ? 0 : 1;
        }
    }
    return left +
           (knownCount > 0 ? frames * known / double(knownCount) * double(unknownCount) : 0.0);
}

std::vector<SweepRecord> SweepRun::records() const {
    std::vector<SweepRecord> there;
    for (const std::optional<SweepRecord>& record : records_) {
        if (record) {
            there.push_back(*record);
        }
    }
    return there;
}

std::vector<SweepRecord> SweepRun::allRecords() const {
    std::vector<SweepRecord> all = records();
    all.insert(all.end(), others_.begin(), others_.end());
    return all;
}

std::size_t SweepRun::count(SweepRecord::Status status) const {
    return std::size_t(std::count_if(records_.begin(), records_.end(), [&](const auto& record) {
        return record && record->status == status;
    }));
}

void SweepRun::writeResults() const {
    const std::vector<SweepRecord> all = allRecords();
    Json list = Json::array();
    for (const SweepRecord& record : all) {
        list.push_back(toJson(record));
    }
    const Json json = {{"context", context_}, {"benchmarks", list}};
    writeFileAtomically(settings_.folder / "sweep.json", json.dump(1) + "\n");
    writeFileAtomically(settings_.folder / "sweep.csv", toCsv(all));
}

void SweepRun::writeReport() const {
    writeFileAtomically(
        settings_.folder / "report.html",
        makeReport(context_, allRecords(), settings_.folder, settings_.targetPercent));
}

}  // namespace ribalta
