// Beer-Lambert by its own law, and the mean transmittance where its plain form fails.
#include <cmath>

#include <gtest/gtest.h>

#include "optics/shader_lib.h"
#include "shader_lib_float.h"

namespace ribalta {
namespace {

TEST(Haze, TransmittanceMultipliesAlongTheWay) {
    for (const double extinction : {0.0, 0.03, 0.9}) {
        const double whole = shader::transmittance(extinction, 7.5);
        const double parts =
            shader::transmittance(extinction, 2.25) * shader::transmittance(extinction, 5.25);
        EXPECT_NEAR(whole, parts, 1e-15);
    }
    EXPECT_EQ(shader::transmittance(0.5, 0.0), 1.0);
    EXPECT_EQ(shader_float::transmittance(3e38F, 3e38F), 0.0F);
    EXPECT_NEAR(shader::transmittance(0.1, 10.0), 0.36787944117144233, 1e-15);
}

TEST(Haze, MeanTransmittanceHoldsItsBoundInDouble) {
    EXPECT_EQ(shader::oneMinusExpOver(0.0), 1.0);
    for (double x = 1e-12; x < 50.0; x *= 1.1) {
        const double exact = -std::expm1(-x) / x;
        EXPECT_NEAR(shader::oneMinusExpOver(x), exact, 1e-10 * exact) << "x " << x;
    }
}

TEST(Haze, MeanTransmittanceHoldsItsBoundInFloat) {
    for (float x = 1e-12F; x < 50.0F; x *= 1.01F) {
        const double exact = -std::expm1(-double(x)) / double(x);
        EXPECT_NEAR(shader_float::oneMinusExpOver(x), exact, 7e-6 * exact) << "x " << x;
    }
}

}  // namespace
}  // namespace ribalta
