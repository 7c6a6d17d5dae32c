// A sky's record: what counts as its error, and what is written of it.
#include "measure/sky_record.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "make_picture.h"

namespace ribalta {
namespace {

const SkyViewpoint& viewNamed(const std::string& name) {
    for (const SkyViewpoint& view : skyViewpoints()) {
        if (view.name == name) {
            return view;
        }
    }
    throw std::runtime_error("no view " + name);
}

TEST(SkyPictureError, IsRelativeAndCountsWhatIsBrightEnough) {
    const SkyViewpoint& view = viewNamed("inside");
    const SkyOverScene truth = truthOf(view, skyRows().front(), true);
    const RgbPicture right = test::makeFlat(20, 10, {1000.0F, 2000.0F, 0.1F});
    EXPECT_EQ(skyPictureError(right, right, view, truth).largest, 0.0);

    RgbPicture drawn = right;
    for (glm::vec3& pixel : drawn.pixels) {
        pixel *= glm::vec3(1.01F, 0.97F, 50.0F);  // blue is below 1e-6 of the sun
    }
    drawn.pixels[7].x = 0.0F;
    const SkyPictureError error = skyPictureError(drawn, right, view, truth);
    EXPECT_NEAR(error.median, 0.02, 0.011);
    EXPECT_NEAR(error.p95, 0.03, 1e-5);
    EXPECT_NEAR(error.largest, 1.0, 1e-6);
    EXPECT_GT(error.displayRmsePercent, 0.0);
    EXPECT_TRUE(std::isfinite(error.psnr));
}

TEST(SkyPictureError, LeavesTheSunsDiscOut) {
    const SkyViewpoint& view = viewNamed("sunset");
    const SkyOverScene truth = truthOf(view, skyRows().front(), true);
    const Camera camera = cameraOf(view);
    const glm::dvec2 half = viewHalfExtent(camera, 320, 180);
    const double ahead = glm::dot(truth.towardsSun, camera.frame.forward());
    const double across = glm::dot(truth.towardsSun, camera.frame.right()) / ahead / half.x;
    const double up = glm::dot(truth.towardsSun, camera.frame.up()) / ahead / half.y;
    ASSERT_LT(std::abs(across), 1.0) << "the sun is in this view";
    ASSERT_LT(std::abs(up), 1.0);
    const RgbPicture right = test::makeFlat(320, 180, glm::vec3(1000.0F));
    RgbPicture drawn = right;
    const auto x = int((0.5 + 0.5 * across) * 320.0);
    const auto y = int((0.5 - 0.5 * up) * 180.0);
    drawn.pixels[std::size_t(y) * 320 + std::size_t(x)] = glm::vec3(1e9F);
    EXPECT_EQ(skyPictureError(drawn, right, view, truth).largest, 0.0);
    drawn.pixels[std::size_t(y - 8) * 320 + std::size_t(x)] = glm::vec3(1100.0F);
    EXPECT_NEAR(skyPictureError(drawn, right, view, truth).largest, 0.1, 1e-5);
}

TEST(SkyRows, HaveNamesOfTheirOwnAndOrdersThatTheirModelsKnow) {
    std::vector<std::string> names;
    int fromThesis = 0;
    for (const SkyRow& row : skyRows()) {
        EXPECT_EQ(std::count(names.begin(), names.end(), row.name), 0) << row.name;
        names.push_back(row.name);
        fromThesis += row.thesis ? 1 : 0;
        if (const auto* tables = std::get_if<PrecomputedSkySettings>(&row.model)) {
            EXPECT_EQ(row.orders.count, tables->orders) << row.name;
            EXPECT_FALSE(row.orders.closed);
        } else if (std::holds_alternative<ChapmanSky>(row.model)) {
            EXPECT_EQ(row.orders.count, 1);
            EXPECT_TRUE(row.rayleighOnly);
        }
    }
    EXPECT_EQ(fromThesis, 3);
    EXPECT_EQ(skyViewpoints().size(), 6U);
}

TEST(SkyRecord, JsonCsvAndTableAgree) {
    SkyRecord record;
    record.view = "sunset";
    record.row = "chapman";
    record.width = 48;
    record.height = 27;
    record.bytes = 2048;
    record.skyMs = {3.25, 0.5};
    record.own.median = 0.125;
    record.own.psnr = std::numeric_limits<double>::infinity();
    SkyRecord failed = record;
    failed.view = "inside";
    failed.failed = true;
    failed.message = "no room, \"none\"";
    const nlohmann::json json = toJson(record);
    EXPECT_EQ(json.at("name"), "sunset/chapman/48x27");
    EXPECT_EQ(json.at("thesis").at("ms"), 0.0014);
    EXPECT_TRUE(json.at("own").at("psnr_db").is_null());
    const std::string csv = toCsv({record, failed});
    EXPECT_EQ(csv.substr(0, 16), "name,view,model,");
    EXPECT_NE(csv.find(",3.25,0.5,"), std::string::npos) << csv;
    EXPECT_NE(csv.find("failed,\"no room, \"\"none\"\"\""), std::string::npos) << csv;
    const std::string table = skyTable({record, failed});
    EXPECT_NE(table.find("12.500%"), std::string::npos) << table;
    EXPECT_EQ(table.find("auto "), std::string::npos) << "only what was measured";
}

}  // namespace
}  // namespace ribalta
