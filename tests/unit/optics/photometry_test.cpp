// Luminance and exposure values by their definitions.
#include "optics/photometry.h"

#include <gtest/gtest.h>

#include "optics/shader_lib.h"

namespace ribalta {
namespace {

TEST(Photometry, LuminanceOfWhiteAndOfThePrimaries) {
    EXPECT_NEAR(luminance({1.0, 1.0, 1.0}), 1.0, 1e-12);
    EXPECT_GT(luminance({0.0, 1.0, 0.0}), luminance({1.0, 0.0, 0.0}));
    EXPECT_GT(luminance({1.0, 0.0, 0.0}), luminance({0.0, 0.0, 1.0}));
}

TEST(Photometry, WhiteIsExposedToOne) {
    for (const double white : {0.01, 1.0, 4000.0}) {
        EXPECT_NEAR(white * shader::exposureFromEv100(ev100FromWhiteLuminance(white)), 1.0, 1e-12);
    }
}

TEST(Photometry, AMeteredAverageIsAboutATenthOfWhite) {
    EXPECT_NEAR(ev100FromAverageLuminance(0.125), 0.0, 1e-12);
    EXPECT_NEAR(ev100FromAverageLuminance(4096.0), 15.0, 1e-12);
    const double shown = 50.0 * shader::exposureFromEv100(ev100FromAverageLuminance(50.0));
    EXPECT_NEAR(shown, 0.104, 0.001);
}

}  // namespace
}  // namespace ribalta
