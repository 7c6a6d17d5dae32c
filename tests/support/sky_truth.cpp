#include "sky_truth.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>

namespace ribalta::test {
namespace {

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells(1);
    for (const char c : line) {
        if (c == ',') {
            cells.emplace_back();
        } else if (c != '\r') {
            cells.back() += c;
        }
    }
    return cells;
}

}  // namespace

std::filesystem::path truthFolder() {
    const char* given = std::getenv("RIBALTA_SKY_TRUTH");
    return given != nullptr ? std::filesystem::path(given)
                            : std::filesystem::path(RIBALTA_SOURCE_DIR) / "../shared/truth";
}

std::vector<TruthRow> readTruth(const std::filesystem::path& file) {
    std::ifstream stream(file);
    std::string line;
    std::getline(stream, line);
    const std::vector<std::string> names = split(line);
    std::vector<TruthRow> rows;
    while (std::getline(stream, line)) {
        const std::vector<std::string> cells = split(line);
        TruthRow row;
        for (std::size_t i = 0; i < std::min(names.size(), cells.size()); ++i) {
            row[names[i]] = cells[i];
        }
        rows.push_back(row);
    }
    return rows;
}

double number(const TruthRow& row, const std::string& name) {
    return std::stod(row.at(name));
}

SkyRay rayOf(const TruthRow& row) {
    SkyRay ray{1000.0 * number(row, "alt_km"), number(row, "mu"), number(row, "mu_s"),
               number(row, "nu")};
    if (row.contains("d_km")) {
        ray.distanceMetres = 1000.0 * number(row, "d_km");
    }
    return ray;
}

void SkyErrors::add(const TruthRow& row, const std::string& columns, const glm::dvec3& got,
                    double darkest) {
    glm::dvec3 right(0.0);
    for (int c = 0; c < 3; ++c) {
        right[c] = number(row, columns + "_" + "rgb"[c]);
    }
    add(right, got, darkest);
}

void SkyErrors::add(const glm::dvec3& right, const glm::dvec3& got, double darkest) {
    for (int c = 0; c < 3; ++c) {
        if (right[c] > darkest) {
            errors_.push_back(std::abs(got[c] / right[c] - 1.0));
        }
    }
}

double SkyErrors::quantile(double part) {
    std::sort(errors_.begin(), errors_.end());
    return errors_.at(std::min(errors_.size() - 1, std::size_t(part * double(errors_.size()))));
}

void SkyErrors::expectBelow(const char* what, const std::array<double, 4>& bounds) {
    ASSERT_GT(errors_.size(), 10U) << what;
    constexpr std::array<double, 4> kParts = {0.5, 0.9, 0.95, 1.0};
    std::printf("%s of %zu: median %.2g, p90 %.2g, p95 %.2g, largest %.2g\n", what, errors_.size(),
                quantile(0.5), quantile(0.9), quantile(0.95), quantile(1.0));
    for (std::size_t i = 0; i < kParts.size(); ++i) {
        EXPECT_LE(quantile(kParts[i]), bounds[i]) << what << ", " << kParts[i];
    }
}

}  // namespace ribalta::test
