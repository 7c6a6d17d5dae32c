// The sky's reference against independent tables of the same model: those of another program, in 22
// digits for single scattering, by random walks for more. They are not part of the project:
// RIBALTA_SKY_TRUTH, or ../shared/truth beside the checkout, with sky.csv, aerial.csv and
// irradiance.csv.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/parallel_for.h"
#include "reference/integrate_sky.h"

namespace ribalta {
namespace {

constexpr double kDarkest = 1e-6;  // radiance from which on a relative error counts

std::filesystem::path truthFolder() {
    const char* given = std::getenv("RIBALTA_SKY_TRUTH");
    return given != nullptr ? std::filesystem::path(given)
                            : std::filesystem::path(RIBALTA_SOURCE_DIR) / "../shared/truth";
}

using Row = std::map<std::string, std::string>;

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

std::vector<Row> readRows(const std::filesystem::path& file) {
    std::ifstream stream(file);
    std::string line;
    std::getline(stream, line);
    const std::vector<std::string> names = split(line);
    std::vector<Row> rows;
    while (std::getline(stream, line)) {
        const std::vector<std::string> cells = split(line);
        Row row;
        for (std::size_t i = 0; i < std::min(names.size(), cells.size()); ++i) {
            row[names[i]] = cells[i];
        }
        rows.push_back(row);
    }
    return rows;
}

double number(const Row& row, const std::string& name) {
    return std::stod(row.at(name));
}

SkyRay rayOf(const Row& row) {
    SkyRay ray{1000.0 * number(row, "alt_km"), number(row, "mu"), number(row, "mu_s"),
               number(row, "nu")};
    if (row.contains("d_km")) {
        ray.distanceMetres = 1000.0 * number(row, "d_km");
    }
    return ray;
}

/// How far values are off, in parts of what they should be.
class Errors {
  public:
    void add(const Row& row, const std::string& columns, const glm::dvec3& got,
             double darkest = kDarkest) {
        for (int c = 0; c < 3; ++c) {
            const double right = number(row, columns + "_" + "rgb"[c]);
            if (right > darkest) {
                errors_.push_back(std::abs(got[c] / right - 1.0));
            }
        }
    }
    /// Bounds of the median, of 90, 95 and 100 % of the errors.
    void expectBelow(const char* what, const std::array<double, 4>& bounds) {
        ASSERT_GT(errors_.size(), 10U) << what;
        std::sort(errors_.begin(), errors_.end());
        const auto quantile = [&](double part) {
            return errors_[std::min(errors_.size() - 1,
                                    std::size_t(part * double(errors_.size())))];
        };
        constexpr std::array<double, 4> kParts = {0.5, 0.9, 0.95, 1.0};
        std::printf("%s of %zu: median %.2g, p90 %.2g, p95 %.2g, largest %.2g\n", what,
                    errors_.size(), quantile(0.5), quantile(0.9), quantile(0.95), quantile(1.0));
        for (std::size_t i = 0; i < kParts.size(); ++i) {
            EXPECT_LE(quantile(kParts[i]), bounds[i]) << what << ", " << kParts[i];
        }
    }

  private:
    std::vector<double> errors_;
};

class SkyTruth : public testing::Test {
  protected:
    void SetUp() override {
        if (!std::filesystem::exists(truthFolder() / "sky.csv")) {
            GTEST_SKIP() << "no tables in " << truthFolder() << "; set RIBALTA_SKY_TRUTH";
        }
        rows_ = readRows(truthFolder() / "sky.csv");
        for (const Row& row : rows_) {
            rays_.push_back(rayOf(row));
        }
    }

    std::vector<Row> rows_;
    std::vector<SkyRay> rays_;
};

TEST_F(SkyTruth, TransmittanceAndLightScatteredOnce) {
    const SkyIntegrator sky(Atmosphere(), {.orders = 1}, rays_);
    const SkyIntegrator clean(withoutMie(Atmosphere()), {.orders = 1}, rays_);
    Errors transmittance;
    Errors single;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        transmittance.add(rows_[i], "T", sky.transmittanceAlong(rays_[i]));
        transmittance.add(rows_[i], "Tray", clean.transmittanceAlong(rays_[i]));
        const SingleScattering light = sky.singleAlong(rays_[i]);
        single.add(rows_[i], "L1", light.sum());
        single.add(rows_[i], "L1R", light.rayleigh);
        single.add(rows_[i], "L1ray", clean.singleAlong(rays_[i]).sum());
    }
    transmittance.expectBelow("transmittance", {1e-12, 2e-12, 4e-12, 1e-10});
    single.expectBelow("light scattered once", {1e-12, 1e-11, 2e-9, 2e-8});
}

TEST_F(SkyTruth, RaysThatEnd) {
    const SkyIntegrator sky(Atmosphere(), {.orders = 1}, {});
    const SkyIntegrator clean(withoutMie(Atmosphere()), {.orders = 1}, {});
    Errors transmittance;
    Errors single;
    for (const Row& row : readRows(truthFolder() / "aerial.csv")) {
        const SkyRay ray = rayOf(row);
        transmittance.add(row, "T", sky.transmittanceAlong(ray));
        transmittance.add(row, "Tray", clean.transmittanceAlong(ray));
        single.add(row, "L1", sky.singleAlong(ray).sum());
        single.add(row, "L1ray", clean.singleAlong(ray).sum());
    }
    transmittance.expectBelow("transmittance", {1e-12, 1e-12, 1e-12, 1e-11});
    single.expectBelow("light scattered once", {1e-12, 1e-12, 1e-12, 1e-11});
}

// A quarter of a second a ray: every twentieth.
TEST_F(SkyTruth, LightScatteredTwice) {
    const SkyIntegrator sky(Atmosphere(), {.orders = 2}, {});
    std::vector<std::size_t> some;
    for (std::size_t i = 3; i < rows_.size(); i += 20) {
        some.push_back(i);
    }
    std::vector<glm::dvec3> light(some.size());
    parallelFor(some.size(), [&](std::size_t i) { light[i] = sky.orderAlong(rays_[some[i]], 2); });
    Errors errors;
    for (std::size_t i = 0; i < some.size(); ++i) {
        errors.add(rows_[some[i]], "L2", light[i]);
    }
    // The tables' own precision is 8e-6 of the sum of orders.
    errors.expectBelow("light scattered twice", {1e-6, 1e-5, 3e-5, 1e-4});
}

// By the coarse tables. What is left is mostly the standard error of the truth: 8e-5
// (median), 1.4e-3 (p95), 5e-3 at dusk.
TEST_F(SkyTruth, FourOrdersWithAndWithoutTheGround) {
    SkySettings settings;
    settings.exactSecondOrder = false;
    settings.tables = coarseSkyTables();
    const SkyIntegrator sky(Atmosphere(), settings, rays_);
    std::vector<SkyLight> lights(rays_.size());
    parallelFor(rays_.size(), [&](std::size_t i) { lights[i] = sky.along(rays_[i]); });
    Errors air;
    Errors ground;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        air.add(rows_[i], "Lsum4", lights[i].air);
        ground.add(rows_[i], "Ltot4", lights[i].air + lights[i].ground);
    }
    air.expectBelow("four orders", {2e-4, 1e-3, 2e-3, 1e-2});
    ground.expectBelow("four orders and the ground", {2e-4, 1e-3, 2e-3, 1e-2});
}

TEST_F(SkyTruth, IrradianceOfTheGround) {
    const std::vector<Row> rows = readRows(truthFolder() / "irradiance.csv");
    std::vector<SkyRay> rays;
    for (const Row& row : rows) {
        const double muS = number(row, "mu_s");
        rays.push_back({0.0, 1.0, muS, muS});
    }
    SkySettings settings;
    settings.orders = 3;
    settings.tables = coarseSkyTables();
    const SkyIntegrator sky(Atmosphere(), settings, rays);
    Errors direct;
    Errors first;
    Errors later;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        direct.add(rows[i], "Edir", sky.irradiance(0, rays[i].muS));
        first.add(rows[i], "E1", sky.irradiance(1, rays[i].muS));
        later.add(rows[i], "E2", sky.irradiance(2, rays[i].muS));
    }
    direct.expectBelow("direct", {1e-12, 1e-12, 1e-12, 1e-11});
    first.expectBelow("of order 1", {1e-8, 1e-6, 3e-6, 1e-5});
    later.expectBelow("of order 2", {1e-3, 1e-2, 2e-2, 5e-2});
}

}  // namespace
}  // namespace ribalta
