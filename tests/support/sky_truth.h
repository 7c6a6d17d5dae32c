// Independent tables of the sky's light that tests hold the project against. They are not part of
// it: RIBALTA_SKY_TRUTH, or ../shared/truth beside the checkout, with sky.csv, aerial.csv and
// irradiance.csv.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "sky/sky_ray.h"

namespace ribalta::test {

/// Radiance from which on a relative error counts.
inline constexpr double kDarkestTruth = 1e-6;

std::filesystem::path truthFolder();
/// What a test that is skipped says before that folder.
inline constexpr const char* kNoTruth = "set RIBALTA_SKY_TRUTH: there are no tables in ";

/// Cells by the names of their columns.
using TruthRow = std::map<std::string, std::string>;
std::vector<TruthRow> readTruth(const std::filesystem::path& file);
double number(const TruthRow& row, const std::string& name);
SkyRay rayOf(const TruthRow& row);

/// How far values are off, in parts of what they should be.
class SkyErrors {
  public:
    /// Against the columns `columns`_r, _g, _b.
    void add(const TruthRow& row, const std::string& columns, const glm::dvec3& got,
             double darkest = kDarkestTruth);
    void add(const glm::dvec3& right, const glm::dvec3& got, double darkest = kDarkestTruth);
    /// Bounds of the median, of 90, 95 and 100 % of the errors. Prints what they are.
    void expectBelow(const char* what, const std::array<double, 4>& bounds);
    /// The error that this part of all, 0..1, does not exceed.
    double quantile(double part);

  private:
    std::vector<double> errors_;
};

}  // namespace ribalta::test
