// Chapman's function in closed form against the integral it stands for.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "optics/shader_lib.h"
#include "quadrature.h"
#include "shader_lib_float.h"

namespace ribalta {
namespace {

/// The integral of exp(-(height above the start)) along the ray, in scale heights.
double exactChapman(double x, double degrees) {
    const double cosine = std::cos(degrees * std::numbers::pi / 180.0);
    const auto density = [&](double t) {
        const double s = t * (2.0 * x * cosine + t);
        return std::exp(-s / (std::sqrt(x * x + s) + x));
    };
    // In steps that the density changes little over, to where nothing is left of it.
    const double turn = std::max(-x * cosine, 0.0);
    const double step = std::sqrt(x) / 4.0;
    double sum = 0.0;
    for (double t = turn; t > 0.0; t -= step) {
        sum += integratePanel(density, std::max(t - step, 0.0), t);
    }
    for (double t = turn; density(t) > 1e-16 * sum || t == turn; t += step) {
        sum += integratePanel(density, t, t + step);
    }
    return sum;
}

TEST(Chapman, IsWithinItsBoundOfTheIntegral) {
    double worst = 0.0;
    for (const double x : {795.0, 1000.0, 2000.0, 5300.0, 20000.0}) {
        for (double degrees = 0.0; degrees <= 93.0; degrees += 0.25) {
            const double exact = exactChapman(x, degrees);
            const double cosine = std::cos(degrees * std::numbers::pi / 180.0);
            const double off = std::abs(shader::chapman(x, cosine) / exact - 1.0);
            EXPECT_LE(off, 0.0034) << x << ", " << degrees << " degrees";
            worst = std::max(worst, off);
        }
    }
    EXPECT_GT(worst, 0.002) << "the bound says more than is measured";
}

TEST(Chapman, SchulersFormIsOffAsPublished) {
    // Units of half heights: x is 1 / ln 2 times as large, and 1 over the whole is ln 2 less.
    const double unit = std::numbers::ln2;
    for (const auto& [x, degrees, relative] : {std::tuple{795.0, 60.0, -0.0522386},
                                               {795.0, 85.0, -0.154672},
                                               {1000.0, 90.0, -0.0420021},
                                               {1000.0, 95.0, -0.0416919}}) {
        const double exact = exactChapman(x, degrees);
        const double cosine = std::cos(degrees * std::numbers::pi / 180.0);
        const double got = shader::chapmanSchuler(x / unit, cosine);
        EXPECT_NEAR(got / exact - 1.0, relative, 2e-6) << x << ", " << degrees << " degrees";
    }
}

TEST(Chapman, SinglePrecisionHolds) {
    for (const double x : {795.0, 5300.0}) {
        // Beyond, singles lose digits with exp(depth): 95 degrees from 5300 heights up is 20 deep.
        for (double degrees = 0.0; degrees <= 95.0; degrees += 0.5) {
            const auto cosine = float(std::cos(degrees * std::numbers::pi / 180.0));
            const double exact = shader::chapman(double(float(x)), double(cosine));
            EXPECT_NEAR(shader_float::chapman(float(x), cosine), exact, 1e-5 * exact)
                << x << ", " << degrees << " degrees";
        }
    }
}

}  // namespace
}  // namespace ribalta
