// A comparison of skies as one page that a browser shows without a network.
#include <algorithm>

#include <nlohmann/json.hpp>

#include "measure/report_files.h"
#include "measure/report_html.h"
#include "measure/sky_record.h"
#include "measure/sweep_report.h"

namespace ribalta {
namespace {

using Json = nlohmann::json;

std::string percent(double part) {
    return shortNumber(100.0 * part);
}

std::string saysOf(const SkyRecord& record) {
    for (const SkyRow& row : skyRows()) {
        if (row.name == record.row) {
            return row.name + ": " + row.says;
        }
    }
    return record.row;
}

std::string figureHtml(const SkyRecord& record, const std::filesystem::path& folder) {
    const std::string picture = imageTag(folder, record.picture, saysOf(record));
    if (picture.empty()) {
        return "";
    }
    return "<figure>" + picture +
           imageTag(folder, record.difference, "difference of " + record.row) + "<figcaption>" +
           escaped(saysOf(record)) + "; " + shortNumber(record.skyMs.median) +
           " ms; radiance off by " + percent(record.own.median) +
           " % (95 %: " + percent(record.own.p95) + " %), shown " +
           shortNumber(record.own.displayRmsePercent) + " %, FLIP " + shortNumber(record.own.flip) +
           "; from the whole truth " + percent(record.whole.median) + " %</figcaption></figure>\n";
}

std::string viewHtml(const SkyViewpoint& view, const std::vector<SkyRecord>& records,
                     const std::filesystem::path& folder) {
    std::string figures;
    std::string reference;
    for (const SkyRecord& record : records) {
        if (record.view == view.name) {
            figures += figureHtml(record, folder);
            if (reference.empty()) {
                reference = imageTag(folder, record.reference, "the reference, every order");
            }
        }
    }
    if (figures.empty()) {
        return "";
    }
    return "<section>\n<h2>" + escaped(view.says) + "</h2>\n<div class=\"pictures\"><figure>" +
           reference + "<figcaption>the reference, every order</figcaption></figure></div>\n" +
           "<div class=\"pictures\">\n" + figures +
           "</div>\n<p class=\"note\">Below each picture its difference from the reference of the "
           "same orders and air: black is none, white " +
           shortNumber(kReportDifferencePercent) +
           " % of full scale and above, the largest channel of each pixel.</p>\n</section>\n";
}

std::string tableHtml(const std::vector<SkyRecord>& records) {
    std::string html =
        "<p class=\"note\">Medians; in brackets the distance between quartiles. Errors of radiance "
        "in %, of pixels brighter than 1e-6 of the sun that do not see its disc.</p>\n"
        "<div class=\"scroll\"><table id=\"points\">\n" +
        headings({{"view", "text"},
                  {"model", "text"},
                  {"KB", ""},
                  {"KB at most", ""},
                  {"tables, ms", ""},
                  {"CPU s", ""},
                  {"sky GPU, ms", ""},
                  {"frame, ms", ""},
                  {"error, median", ""},
                  {"95 %", ""},
                  {"largest", ""},
                  {"RMSE shown, %", ""},
                  {"FLIP", ""},
                  {"from the whole truth", ""},
                  {"", "text"}}) +
        "<tbody>\n";
    for (const SkyRecord& record : records) {
        html += "<tr>" + cell(escaped(record.view), "text") + cell(escaped(record.row), "text");
        if (record.failed) {
            html += "<td class=\"message\" colspan=\"13\">failed: " + escaped(record.message) +
                    "</td></tr>\n";
            continue;
        }
        const auto spread = [](const Spread& value) {
            return shortNumber(value.median) + " (" + shortNumber(value.iqr) + ")";
        };
        html += cell(shortNumber(double(record.bytes) / 1024.0)) +
                cell(shortNumber(double(record.peakBytes) / 1024.0)) +
                cell(shortNumber(record.tablesMs)) + cell(shortNumber(record.tablesCpuSeconds)) +
                cell(spread(record.skyMs)) + cell(spread(record.frameMs)) +
                cell(percent(record.own.median)) + cell(percent(record.own.p95)) +
                cell(percent(record.own.largest)) +
                cell(shortNumber(record.own.displayRmsePercent)) +
                cell(shortNumber(record.own.flip)) + cell(percent(record.whole.median)) +
                cell(escaped(record.message), "message") + "</tr>\n";
    }
    return html + "</tbody></table></div>";
}

}  // namespace

std::string makeSkyReport(const Json& context, const std::vector<SkyRecord>& records,
                          const std::filesystem::path& folder) {
    const auto& files = reportFiles();
    std::string views;
    for (const SkyViewpoint& view : skyViewpoints()) {
        views += viewHtml(view, records, folder);
    }
    return filled(files.at("report.html"),
                  {{"title", "Skies: six viewpoints, beside the thesis"},
                   {"style", std::string(files.at("report.css"))},
                   {"context", contextHtml(context)},
                   {"summary", "<section>\n<h2>Beside the thesis</h2>\n<pre>" +
                                   escaped(skyTable(records)) + "</pre>\n</section>"},
                   {"views", views},
                   {"table", tableHtml(records)},
                   {"data", "{}"},
                   {"library", ""},
                   {"script", ""}});
}

}  // namespace ribalta
