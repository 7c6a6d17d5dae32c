// How much of a cloud of haze lies on a way: closed form against sums.
#include <cmath>

#include <gtest/gtest.h>

#include "optics/shader_lib.h"

namespace ribalta {
namespace {

double summedMetres(const glm::dvec3& from, const glm::dvec3& way, const glm::dvec3& perMetre,
                    double metres) {
    constexpr int kSteps = 20000;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const glm::dvec3 at = (from + way * (metres * (i + 0.5) / kSteps)) * perMetre;
        sum += std::exp(-glm::dot(at, at)) * metres / kSteps;
    }
    return sum;
}

TEST(HazeCloud, MetresAreThoseSummedUp) {
    const glm::dvec3 perMetre(0.05, 0.1, 0.02);
    const glm::dvec3 ways[] = {{1, 0, 0}, {0, -1, 0}, {0.6, 0, 0.8}, {-0.48, 0.6, 0.64}};
    for (const glm::dvec3& from :
         {glm::dvec3(0, 0, 0), glm::dvec3(-30, 5, 10), glm::dvec3(20, -8, -70)}) {
        for (const glm::dvec3& way : ways) {
            for (const double metres : {0.0, 0.5, 20.0, 200.0}) {
                EXPECT_NEAR(shader::hazeCloudMetres(from, way, perMetre, metres),
                            summedMetres(from, way, perMetre, metres), 2e-5)
                    << metres;
            }
        }
    }
}

TEST(HazeCloud, ErrorFunctionIsGoodEnough) {
    for (double x = -7.0; x <= 7.0; x += 0.01) {
        EXPECT_NEAR(shader::errorFunction(x), std::erf(x), 2e-7) << x;
    }
}

}  // namespace
}  // namespace ribalta
