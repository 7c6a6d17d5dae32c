// The report as text. What a browser makes of it is tests/cli's.
#include "measure/sweep_report.h"

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "make_record.h"
#include "support/test_folder.h"

namespace ribalta::test {
namespace {

std::string reportOf(const std::vector<SweepRecord>& records, const TestFolder& folder) {
    return makeReport({{"renderer", "llvmpipe <1>"}}, records, folder.path(), 0.5);
}

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::vector<SweepRecord> twoMethods() {
    return {makeRecord(BeamMethod::kPlanes, 8, 100.0, 8.0),
            makeRecord(BeamMethod::kPlanes, 16, 200.0, 4.0),
            makeRecord(BeamMethod::kClipped, 8, 2.0, 1.0),
            makeRecord(BeamMethod::kClipped, 16, 8.0, 0.25)};
}

TEST(SweepReport, NeedsNoNetwork) {
    const std::string page = reportOf(twoMethods(), TestFolder());
    for (const char* outside :
         {"src=\"http", "href=\"http", "@import", "url(http", "<link rel=\"style"}) {
        EXPECT_FALSE(holds(page, outside)) << outside;
    }
    EXPECT_TRUE(holds(page, "Chart.js v"));
    EXPECT_FALSE(holds(page, "{{"));
}

TEST(SweepReport, TimesAreComparedAtTheTarget) {
    const std::vector<TimeToError> times = timesToError(twoMethods(), 0.5);
    ASSERT_EQ(times.size(), 2U);
    EXPECT_FALSE(times[0].timeMs.has_value());
    EXPECT_EQ(times[0].leastError, 4.0);
    EXPECT_EQ(times[0].longestMs, 200.0);
    EXPECT_NEAR(times[1].timeMs.value(), 4.0, 1e-9);
    const std::string page = reportOf(twoMethods(), TestFolder());
    EXPECT_TRUE(holds(page, "not within 200"));
    EXPECT_TRUE(holds(page, "over 50"));
}

TEST(SweepReport, ATableHoldsEveryPointWithoutAScript) {
    std::vector<SweepRecord> records = twoMethods();
    SweepRecord failed;
    failed.key = "x";
    failed.point = records.front().point;
    failed.message = "no <memory>";
    records.push_back(failed);
    const std::string page = reportOf(records, TestFolder());
    EXPECT_TRUE(holds(page, "failed: no &lt;memory&gt;"));
    EXPECT_TRUE(holds(page, "llvmpipe &lt;1&gt;"));
    EXPECT_TRUE(holds(page, "0.0125"));
    // On the front are the two clipped ones.
    std::size_t front = 0;
    for (std::size_t at = 0; (at = page.find("<tr class=\"front\">", at)) != std::string::npos;
         ++at) {
        ++front;
    }
    EXPECT_EQ(front, 2U);
}

TEST(SweepReport, WhatAFileSaysCannotBreakOutOfThePage) {
    std::vector<SweepRecord> records = twoMethods();
    for (SweepRecord& record : records) {
        record.point.camera = "</script><script>alert(1)</script>{{table}}";
    }
    const std::string page = reportOf(records, TestFolder());
    EXPECT_FALSE(holds(page, "<script>alert"));
}

TEST(SweepReport, PicturesAreInIt) {
    const TestFolder folder;
    folder.write("a.png", std::string_view("Man"));
    std::vector<SweepRecord> records = twoMethods();
    records[0].picture = "a.png";
    records[1].picture = "missing.png";
    const std::string page = reportOf(records, folder);
    EXPECT_TRUE(holds(page, "data:image/png;base64,TWFu\""));
    EXPECT_TRUE(holds(page, "8 sheets, 100 ms, 8 %"));
}

TEST(SweepReport, WithoutReferencesItSaysSo) {
    std::vector<SweepRecord> records = twoMethods();
    for (SweepRecord& record : records) {
        record.errors.clear();
    }
    EXPECT_TRUE(timesToError(records, 0.5).empty());
    EXPECT_TRUE(holds(reportOf(records, TestFolder()), "No reference was drawn"));
    EXPECT_FALSE(reportOf({}, TestFolder()).empty());
}

}  // namespace
}  // namespace ribalta::test
