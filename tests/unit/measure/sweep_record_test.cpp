// Records through JSON and CSV and back.
#include "measure/sweep_record.h"

#include <limits>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "make_record.h"
#include "measure/pessoa2007.h"

namespace ribalta::test {
namespace {

std::vector<std::string> linesOf(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    return lines;
}

TEST(SweepRecord, ComesBackFromJson) {
    SweepRecord record = makeRecord(BeamMethod::kPlanes, 40, 12.5, 0.75);
    record.point.label = "A-1";
    record.point.settings.beams.cellsAcross = 20;
    record.point.settings.beams.cellsDown = 30;
    record.point.settings.beams.spacingMetres = 0.1;
    record.point.settings.haze.phase = {PhaseFunction::Kind::kHenyeyGreenstein, 0.6, 0.1};
    record.message = "a \"message\", with\nlines";
    record.errors.push_back(
        {"geometry", 0.5, 0.0, std::numeric_limits<double>::infinity(), 0.0, 0});
    const nlohmann::json json = toJson(record);
    EXPECT_EQ(toJson(recordFromJson(nlohmann::json::parse(json.dump()))), json);
    // Google Benchmark's own members.
    EXPECT_EQ(json.at("name"), "stage/front/1280x720/A-1/planes 20x30 cells dt 0.1 m/40");
    EXPECT_EQ(json.at("real_time"), 22.5);
    EXPECT_EQ(json.at("cpu_time"), 2.0);
    EXPECT_EQ(json.at("time_unit"), "ms");
    EXPECT_TRUE(json.at("errors").at(1).at("psnr_db").is_null());
}

TEST(SweepRecord, ArbitraryJsonIsNoRecord) {
    EXPECT_THROW(recordFromJson(nlohmann::json::parse("{\"name\": 3}")), nlohmann::json::exception);
    nlohmann::json json = toJson(makeRecord(BeamMethod::kClipped, 8, 1.0, 1.0));
    json["settings"]["beams"] = "no such method";
    EXPECT_ANY_THROW(recordFromJson(json));
}

TEST(SweepRecord, CsvHasALineForEachAndAColumnForEveryPassAndReference) {
    SweepRecord other = makeRecord(BeamMethod::kClipped, 16, 3.0, 0.5);
    other.passes.push_back({"tonemap", {0.1, 0.0}, {0.2, 0.0}});
    other.errors.push_back({"geometry", 0.02, 0.9, 40.0, 0.03, 2e-6});
    SweepRecord failed;
    failed.point = other.point;
    failed.message = "out of memory, \"all\" of it";
    const std::vector<std::string> lines =
        linesOf(toCsv({makeRecord(BeamMethod::kPlanes, 8, 50.0, 9.0), other, failed}));
    ASSERT_EQ(lines.size(), 4U);
    for (const char* column :
         {"beams_gpu_ms", "tonemap_gpu_ms_iqr", "display_rmse_percent@geometry",
          "flip_mean@shadow-map", "peak_rss_bytes"}) {
        EXPECT_NE(lines[0].find(column), std::string::npos) << column;
    }
    EXPECT_NE(lines[3].find("failed,\"out of memory, \"\"all\"\" of it\""), std::string::npos)
        << lines[3];
    const auto commas = [](const std::string& line) {
        return std::count(line.begin(), line.end(), ',');
    };
    EXPECT_EQ(commas(lines[0]), commas(lines[1]));
    EXPECT_EQ(commas(lines[0]), commas(lines[2]));
    EXPECT_EQ(commas(lines[0]) + 1, commas(lines[3]));  // the one within quotes
}

TEST(SweepRecord, ViewsAndMethodsTellWhatBelongsTogether) {
    const SweepPoint planes = makeRecord(BeamMethod::kPlanes, 8, 1.0, 1.0).point;
    SweepPoint clipped = makeRecord(BeamMethod::kClipped, 16, 1.0, 1.0).point;
    EXPECT_EQ(planes.view(), clipped.view());
    EXPECT_NE(planes.method(), clipped.method());
    clipped.settings.width = 640;
    EXPECT_NE(planes.view(), clipped.view());
    SweepPoint fine = makeRecord(BeamMethod::kAdaptive, 8, 1.0, 1.0).point;
    SweepPoint coarse = fine;
    fine.settings.beams.tolerance = 0.001;
    coarse.settings.beams.tolerance = 0.1;
    EXPECT_NE(fine.method(), coarse.method());
}

TEST(Pessoa2007, TheTableHasSixLinesAndWhatWasMeasured) {
    ASSERT_EQ(thesisFigures().size(), 6U);
    const ThesisFigure& figure = thesisFigures()[3];
    EXPECT_STREQ(figure.label, "A-4");
    SweepRecord record = makeRecord(BeamMethod::kPlanes, 45, 90.0, 12.0);
    record.point.label = "A-4";
    record.point.settings = thesisSettings(figure, BeamMethod::kPlanes, 640, 480);
    EXPECT_EQ(record.point.settings.beams.planes, 45);
    EXPECT_EQ(record.point.settings.beams.cellsAcross, 20);
    EXPECT_EQ(record.point.settings.beams.spacingMetres, 0.06);
    EXPECT_EQ(record.point.settings.haze.scatteringPerMetre, 0.3);
    EXPECT_EQ(record.point.settings.haze.phase.k, 25.0);
    const std::vector<std::string> lines = linesOf(thesisTable({record}));
    ASSERT_EQ(lines.size(), 8U);
    EXPECT_NE(lines[5].find("43 fps"), std::string::npos) << lines[5];
    EXPECT_NE(lines[5].find("10.00 fps"), std::string::npos) << lines[5];
    EXPECT_EQ(thesisSettings(figure, BeamMethod::kClipped, 640, 480).beams.cellsAcross, 0);
}

}  // namespace
}  // namespace ribalta::test
