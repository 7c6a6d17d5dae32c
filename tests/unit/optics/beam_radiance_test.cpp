// The integrand of the beams by hand-worked values.
#include <cmath>

#include <gtest/gtest.h>

#include "optics/shader_lib.h"
#include "shader_lib_float.h"

namespace ribalta {
namespace {

TEST(BeamRadiance, IsTheProductOfItsFactors) {
    // 2 m from the lamp, 3 m to the eye: exp(-0.5) / 4 * 0.25 * 0.08.
    EXPECT_NEAR(shader::scatteredIntensity(0.25, 0.08, 0.1, 2.0, 3.0), 0.6065306597126334 * 0.005,
                1e-15);
    EXPECT_NEAR(shader::scatteredShare(0.25, 0.08, 0.1, 2.0, 3.0), 0.6065306597126334 * 0.02,
                1e-15);
}

TEST(BeamRadiance, ScatteringCosineIsOneLookingIntoTheLamp) {
    // The light comes along +z, the eye looks along -z.
    EXPECT_EQ(shader::scatteringCosine({0.0, 0.0, 3.0}, {0.0, 0.0, -1.0}), 1.0);
    EXPECT_EQ(shader::scatteringCosine({0.0, 0.0, 3.0}, {0.0, 0.0, 1.0}), -1.0);
    EXPECT_EQ(shader::scatteringCosine({0.0, 0.0, 3.0}, {1.0, 0.0, 0.0}), 0.0);
    EXPECT_NEAR(shader::scatteringCosine({1.0, 0.0, 1.0}, {0.0, 0.0, -1.0}), std::sqrt(0.5), 1e-15);
}

TEST(BeamRadiance, ScatteringCosineStaysInRange) {
    for (const float size : {0.0F, 1e-30F, 1e-3F, 1.0F, 1e9F, 1e15F}) {
        const glm::vec3 along = glm::normalize(glm::vec3(0.3F, -0.7F, 0.2F));
        const float cosine = shader_float::scatteringCosine(size * along, along);
        EXPECT_TRUE(cosine >= -1.0F && cosine <= 1.0F) << "size " << size;
    }
}

}  // namespace
}  // namespace ribalta
