#include "measure/sweep_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include <nlohmann/json.hpp>

#include "measure/pareto.h"
#include "measure/pessoa2007.h"
#include "measure/report_files.h"
#include "measure/report_html.h"

namespace ribalta {
namespace {

using Json = nlohmann::json;
using Records = std::vector<const SweepRecord*>;

std::vector<std::string> namesInOrder(const std::vector<SweepRecord>& records,
                                      std::string (SweepPoint::*nameOf)() const) {
    std::vector<std::string> names;
    for (const SweepRecord& record : records) {
        const std::string name = (record.point.*nameOf)();
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            names.push_back(name);
        }
    }
    return names;
}

bool isMeasured(const SweepRecord& record) {
    return record.status == SweepRecord::Status::kMeasured;
}

Records measuredIn(const std::vector<SweepRecord>& records, const std::string& view) {
    Records found;
    for (const SweepRecord& record : records) {
        if (isMeasured(record) && record.point.view() == view) {
            found.push_back(&record);
        }
    }
    return found;
}

std::vector<Cost> costsOf(const Records& records) {
    std::vector<Cost> costs;
    for (const SweepRecord* record : records) {
        costs.push_back({record->beamsMs(),
                         record->errors.empty() ? NAN : record->errors.front().displayRmsePercent});
    }
    return costs;
}

// The keys of the records on their view's front.
std::set<std::string> frontKeys(const std::vector<SweepRecord>& records) {
    std::set<std::string> keys;
    for (const std::string& view : namesInOrder(records, &SweepPoint::view)) {
        const Records inView = measuredIn(records, view);
        for (const std::size_t i : paretoFront(costsOf(inView))) {
            keys.insert(inView[i]->key);
        }
    }
    return keys;
}

// What the charts need of the records; what is written within a script must not end it.
std::string chartData(const std::vector<SweepRecord>& records, double targetPercent) {
    const std::set<std::string> front = frontKeys(records);
    Json list = Json::array();
    for (const SweepRecord& record : records) {
        if (!isMeasured(record)) {
            continue;
        }
        list.push_back(
            {{"view", record.point.view()},
             {"method", record.point.method()},
             {"planes", record.point.settings.beams.planes},
             {"fps", record.fps()},
             {"frame_ms", record.frameMs.median},
             {"frame_ms_iqr", record.frameMs.iqr},
             {"beams_ms", record.beamsMs()},
             {"error",
              record.errors.empty() ? Json() : Json(record.errors.front().displayRmsePercent)},
             {"front", front.contains(record.key)}});
    }
    const Json data = {{"methods", namesInOrder(records, &SweepPoint::method)},
                       {"target_percent", targetPercent},
                       {"records", list}};
    std::string text = data.dump();
    for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;) {
        text.replace(at, 1, "\\u003c");
    }
    return text;
}

std::string summaryHtml(const std::vector<SweepRecord>& records, double targetPercent) {
    const std::vector<TimeToError> times = timesToError(records, targetPercent);
    if (times.empty()) {
        return "";
    }
    std::string rows;
    for (const TimeToError& each : times) {
        const auto base = std::find_if(times.begin(), times.end(), [&](const TimeToError& other) {
            return other.view == each.view && other.isBaseline;
        });
        std::string ratio;
        if (each.timeMs && base != times.end() && !each.isBaseline) {
            ratio = base->timeMs ? shortNumber(*base->timeMs / *each.timeMs)
                                 : "over " + shortNumber(base->longestMs / *each.timeMs);
        }
        rows += "<tr>" + cell(escaped(each.view), "text") + cell(escaped(each.method), "text") +
                cell(each.timeMs ? shortNumber(*each.timeMs)
                                 : "not within " + shortNumber(each.longestMs)) +
                cell(shortNumber(each.leastError)) + cell(ratio) + "</tr>\n";
    }
    return "<section>\n<h2>Time to " + shortNumber(targetPercent) +
           " % tone-mapped RMSE</h2>\n<div class=\"scroll\"><table>\n" +
           headings(
               {{"view", "text"},
                {"beams", "text"},
                {"GPU ms of the beams", ""},
                {"least error, %", ""},
                {("times faster than " + std::string(beamMethods().front().name)).c_str(), ""}}) +
           "<tbody>\n" + rows +
           "</tbody></table></div>\n<p class=\"note\">Between two measured points the time is "
           "interpolated, both axes logarithmic.</p>\n</section>";
}

// At most four of a method's records, spread over its counts.
Records chosenForPictures(const Records& records) {
    constexpr std::size_t kShown = 4;
    if (records.size() <= kShown) {
        return records;
    }
    Records chosen;
    for (std::size_t i = 0; i < kShown; ++i) {
        chosen.push_back(records[i * (records.size() - 1) / (kShown - 1)]);
    }
    return chosen;
}

std::string figureHtml(const SweepRecord& record, const std::filesystem::path& folder) {
    const std::string says = record.point.method() + ", " +
                             std::to_string(record.point.settings.beams.planes) + " sheets";
    const std::string picture = imageTag(folder, record.picture, says);
    if (picture.empty()) {
        return "";
    }
    std::string caption = std::to_string(record.point.settings.beams.planes) + " sheets, " +
                          shortNumber(record.beamsMs()) + " ms";
    if (!record.errors.empty()) {
        caption += ", " + shortNumber(record.errors.front().displayRmsePercent) + " %, FLIP " +
                   shortNumber(record.errors.front().flip);
    }
    return "<figure>" + picture + imageTag(folder, record.difference, "difference of " + says) +
           "<figcaption>" + escaped(caption) + "</figcaption></figure>\n";
}

std::string picturesHtml(const Records& records, const std::vector<std::string>& methods,
                         const std::filesystem::path& folder) {
    std::string html;
    for (const std::string& method : methods) {
        Records ofMethod;
        std::copy_if(records.begin(), records.end(), std::back_inserter(ofMethod),
                     [&](const SweepRecord* record) { return record->point.method() == method; });
        std::string figures;
        for (const SweepRecord* record : chosenForPictures(ofMethod)) {
            figures += figureHtml(*record, folder);
        }
        if (!figures.empty()) {
            html += "<h3>" + escaped(method) + "</h3>\n<div class=\"pictures\">\n" + figures +
                    "</div>\n";
        }
    }
    return html;
}

std::string viewHtml(const std::string& view, const Records& records,
                     const std::vector<std::string>& methods, const std::filesystem::path& folder) {
    const bool hasErrors = std::any_of(records.begin(), records.end(),
                                       [](const auto* record) { return !record->errors.empty(); });
    const auto chart = [&](const char* kind) {
        return "<div class=\"chart\"><canvas data-chart=\"" + std::string(kind) +
               "\" data-view=\"" + escaped(view) + "\"></canvas></div>\n";
    };
    std::string html = "<section>\n<h2>" + escaped(view) + "</h2>\n";
    html +=
        "<p class=\"without-script\">The charts need JavaScript; all their points are in the "
        "table below.</p>\n<div class=\"charts\">\n" +
        chart("fps") + (hasErrors ? chart("error") : "") + "</div>\n";
    if (!hasErrors) {
        html += "<p class=\"note\">No reference was drawn, so there are no errors.</p>\n";
    }
    std::string reference;
    std::string against;
    for (const SweepRecord* record : records) {
        if (reference.empty() && !record->errors.empty()) {
            reference = imageTag(folder, record->reference, "the reference");
            against = record->errors.front().against;
        }
    }
    if (!reference.empty()) {
        html += "<h3>reference by " + against + "</h3>\n<div class=\"pictures\"><figure>" +
                reference + "</figure></div>\n";
    }
    const std::string pictures = picturesHtml(records, methods, folder);
    if (!pictures.empty()) {
        html += pictures;
        if (hasErrors) {
            html +=
                "<p class=\"note\">Below each picture its difference from the reference: black "
                "is none, white " +
                shortNumber(kReportDifferencePercent) +
                " % of full scale and above, the largest channel of each pixel.</p>\n";
        }
    }
    return html + "</section>\n";
}

std::string tableHtml(const std::vector<SweepRecord>& records) {
    const std::set<std::string> front = frontKeys(records);
    std::string html =
        "<p class=\"note\">Medians; in brackets the distance between quartiles. Points on their "
        "view's Pareto front are in colour.</p>\n<div class=\"scroll\"><table id=\"points\">\n" +
        headings({{"view", "text"},
                  {"beams", "text"},
                  {"sheets", ""},
                  {"fps", ""},
                  {"frame, ms", ""},
                  {"beams GPU, ms", ""},
                  {"RMSE, %", ""},
                  {"beams' relative RMSE", ""},
                  {"PSNR, dB", ""},
                  {"FLIP", ""},
                  {"samples", ""},
                  {"MiB", ""},
                  {"", "text"}}) +
        "<tbody>\n";
    for (const SweepRecord& record : records) {
        const SweepPoint& point = record.point;
        html += front.contains(record.key) ? "<tr class=\"front\">" : "<tr>";
        html +=
            cell(escaped(point.view()), "text") +
            cell(escaped(point.label.empty() ? point.method() : point.label + " " + point.method()),
                 "text") +
            cell(std::to_string(point.settings.beams.planes));
        if (!isMeasured(record)) {
            html += "<td class=\"message\" colspan=\"10\">" + std::string(name(record.status)) +
                    ": " + escaped(record.message) + "</td></tr>\n";
            continue;
        }
        const auto spread = [](const Spread& value) {
            return shortNumber(value.median) + " (" + shortNumber(value.iqr) + ")";
        };
        std::string beams = "0";
        for (const PassSpread& pass : record.passes) {
            beams = pass.name == "beams" ? spread(pass.gpuMs) : beams;
        }
        html += cell(shortNumber(record.fps())) + cell(spread(record.frameMs)) + cell(beams);
        if (record.errors.empty()) {
            html += "<td></td><td></td><td></td><td></td>";
        } else {
            const SweepError& error = record.errors.front();
            html += cell(shortNumber(error.displayRmsePercent)) +
                    cell(shortNumber(error.beamsRelativeRmse)) + cell(shortNumber(error.psnr)) +
                    cell(shortNumber(error.flip));
        }
        html += cell(shortNumber(double(record.samples))) +
                cell(record.peakRss ? shortNumber(double(*record.peakRss) / 1048576.0) : "") +
                cell(escaped(record.message), "message") + "</tr>\n";
    }
    return html + "</tbody></table></div>";
}

}  // namespace

std::vector<TimeToError> timesToError(const std::vector<SweepRecord>& records,
                                      double targetPercent) {
    std::vector<TimeToError> result;
    for (const std::string& view : namesInOrder(records, &SweepPoint::view)) {
        Records pending = measuredIn(records, view);
        std::erase_if(pending, [](const SweepRecord* record) { return record->errors.empty(); });
        while (!pending.empty()) {
            const SweepPoint& first = pending.front()->point;
            Records ofMethod;
            std::erase_if(pending, [&](const SweepRecord* record) {
                const bool isOf = record->point.method() == first.method();
                if (isOf) {
                    ofMethod.push_back(record);
                }
                return isOf;
            });
            const std::vector<Cost> costs = costsOf(ofMethod);
            TimeToError each{view,
                             first.method(),
                             first.settings.beams.method == beamMethods().front().value,
                             timeToError(costs, targetPercent),
                             costs.front().error,
                             0.0};
            for (const Cost& cost : costs) {
                each.leastError = std::min(each.leastError, cost.error);
                each.longestMs = std::max(each.longestMs, cost.timeMs);
            }
            result.push_back(each);
        }
    }
    return result;
}

std::string makeReport(const Json& context, const std::vector<SweepRecord>& records,
                       const std::filesystem::path& folder, double targetPercent) {
    const auto& files = reportFiles();
    const bool hasPreset =
        std::any_of(records.begin(), records.end(),
                    [](const SweepRecord& record) { return !record.point.label.empty(); });
    const std::string thesis = hasPreset ? "<section>\n<h2>Beside the thesis</h2>\n<pre>" +
                                               escaped(thesisTable(records)) + "</pre>\n</section>"
                                         : "";
    const std::vector<std::string> methods = namesInOrder(records, &SweepPoint::method);
    std::string views;
    for (const std::string& view : namesInOrder(records, &SweepPoint::view)) {
        views += viewHtml(view, measuredIn(records, view), methods, folder);
    }
    return filled(files.at("report.html"),
                  {{"title", "Beams: run time against error"},
                   {"style", std::string(files.at("report.css"))},
                   {"context", contextHtml(context)},
                   {"summary", summaryHtml(records, targetPercent) + thesis},
                   {"views", views},
                   {"table", tableHtml(records)},
                   {"data", chartData(records, targetPercent)},
                   {"library", std::string(files.at("chart.min.js"))},
                   {"script", std::string(files.at("report.js"))}});
}

}  // namespace ribalta
