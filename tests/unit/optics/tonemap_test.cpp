// The tone curve by what an eye asks of it: order, range, hue; the encoding by known values.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "optics/shader_lib.h"
#include "shader_lib_float.h"

namespace ribalta {
namespace {

const glm::dvec3 kStageColours[] = {{1.0, 0.0, 0.0},  {0.0, 1.0, 0.0},   {0.0, 0.0, 1.0},
                                    {1.0, 0.4, 0.05}, {0.6, 0.05, 1.0},  {0.0, 0.8, 1.0},
                                    {1.0, 1.0, 1.0},  {1.0, 0.02, 0.35}, {0.02, 0.1, 0.9}};

/// Position of the middle channel between the smallest and the largest: the hue within its sextant.
double hueFraction(const glm::dvec3& c) {
    const double low = std::min({c.x, c.y, c.z});
    const double high = std::max({c.x, c.y, c.z});
    return (c.x + c.y + c.z - 2.0 * low - high) / (high - low);
}

TEST(ToneNeutral, LeavesWhatIsNotBrightAsItIs) {
    const glm::dvec3 color(0.8, 0.0, 0.3);
    EXPECT_EQ(shader::toneNeutral(color), color);
    EXPECT_EQ(shader::toneNeutral(glm::dvec3(0.0)), glm::dvec3(0.0));
    EXPECT_EQ(shader::toneNeutral(glm::dvec3(-1.0, 0.5, -0.0)), glm::dvec3(0.0, 0.5, 0.0));
}

TEST(ToneNeutral, RisesWithTheLightInZeroToOne) {
    for (const glm::dvec3& colour : kStageColours) {
        glm::dvec3 before(-1.0);
        for (double light = 1e-3; light < 1e6; light *= 1.02) {
            const glm::dvec3 shown = shader::toneNeutral(light * colour);
            for (int c = 0; c < 3; ++c) {
                EXPECT_GE(shown[c], before[c]);
                EXPECT_GE(shown[c], 0.0);
                EXPECT_LE(shown[c], 1.0);
            }
            before = shown;
        }
    }
}

TEST(ToneNeutral, KeepsTheHueOfColouredBeams) {
    for (const glm::dvec3& colour : kStageColours) {
        if (colour.x == colour.y && colour.y == colour.z) {
            continue;
        }
        for (double light = 0.01; light < 1e3; light *= 1.5) {
            const glm::dvec3 shown = shader::toneNeutral(light * colour);
            EXPECT_NEAR(hueFraction(shown), hueFraction(colour), 1e-9) << "light " << light;
            for (int a = 0; a < 3; ++a) {
                for (int b = 0; b < 3; ++b) {
                    EXPECT_TRUE(colour[a] < colour[b] || shown[a] >= shown[b]);
                }
            }
        }
    }
}

TEST(ToneNeutral, FadesToWhiteGraduallyNotAtOnce) {
    const glm::dvec3 twice = shader::toneNeutral({2.0, 0.0, 0.0});
    EXPECT_LT(twice.y, 0.2);
    const glm::dvec3 glaring = shader::toneNeutral({500.0, 0.0, 0.0});
    EXPECT_GT(glaring.y, 0.95);
}

TEST(ToneNeutral, HasNoKinkWhereItBegins) {
    const double step = 1e-6;
    const double below = shader::kToneStart - step;
    const double above = shader::kToneStart + step;
    const double slope =
        (shader::toneNeutral(glm::dvec3(above)).x - shader::toneNeutral(glm::dvec3(below)).x) /
        (2.0 * step);
    EXPECT_NEAR(slope, 1.0, 1e-4);
}

TEST(ToneNeutral, IsFiniteForWhatHalfFloatsHold) {
    const float infinity = std::numeric_limits<float>::infinity();
    const float wild[] = {-infinity, -1.0F, 0.0F, 1e-30F, 0.8F, 65504.0F, 3e38F, infinity};
    for (const float r : wild) {
        for (const float g : wild) {
            const glm::vec3 shown = shader_float::toneNeutral({r, g, 0.5F});
            for (int c = 0; c < 3; ++c) {
                EXPECT_TRUE(shown[c] >= 0.0F && shown[c] <= 1.0F) << r << ", " << g;
            }
        }
    }
}

const int kCurves[] = {shader::kToneNeutral, shader::kToneAgx, shader::kToneAces,
                       shader::kToneLinear};

TEST(Tonemap, EveryCurveKeepsGreyGreyAndRises) {
    for (const int curve : kCurves) {
        double before = -1.0;
        for (double light = 1e-4; light < 1e4; light *= 1.05) {
            const glm::dvec3 shown = shader::tonemap(curve, glm::dvec3(light));
            // The published matrices of AgX and ACES have four or five digits.
            EXPECT_NEAR(shown.x, shown.y, 2e-3) << curve << ", " << light;
            EXPECT_NEAR(shown.x, shown.z, 2e-3) << curve << ", " << light;
            // AgX's polynomial falls by this much at its very end.
            EXPECT_GE(shown.y, before - 1e-3) << curve << ", " << light;
            before = shown.y;
        }
        EXPECT_EQ(shader::tonemap(curve, glm::dvec3(0.0)), glm::dvec3(0.0)) << curve;
        EXPECT_GT(before, 0.97) << curve;
    }
}

TEST(Tonemap, EveryCurveLeavesMidGreyInTheMiddle) {
    for (const int curve : kCurves) {
        const double shown = shader::tonemap(curve, glm::dvec3(0.18)).y;
        EXPECT_GT(shown, 0.14) << curve;
        EXPECT_LT(shown, 0.23) << curve;
    }
}

TEST(Tonemap, FilmTakesColourFromBrightLightAndTheLinearCurveDoesNot) {
    const glm::dvec3 blue(0.0, 0.0, 20.0);
    EXPECT_GT(shader::tonemap(shader::kToneAgx, blue).x, 0.3);
    EXPECT_EQ(shader::tonemap(shader::kToneLinear, blue), glm::dvec3(0.0, 0.0, 1.0));
}

TEST(Tonemap, EveryCurveStaysInRangeForWhatFloatsHold) {
    const float infinity = std::numeric_limits<float>::infinity();
    const float wild[] = {-infinity, -1.0F, 0.0F, 1e-38F, 1e-30F, 0.8F, 65504.0F, 3e38F, infinity};
    for (const int curve : kCurves) {
        for (const float r : wild) {
            for (const float g : wild) {
                const glm::vec3 shown = shader_float::tonemap(curve, {r, g, 0.5F});
                for (int c = 0; c < 3; ++c) {
                    EXPECT_TRUE(shown[c] >= 0.0F && shown[c] <= 1.0F)
                        << curve << ": " << r << ", " << g;
                }
            }
        }
    }
}

TEST(Exposure, MapsTheSaturationLuminanceToOne) {
    EXPECT_NEAR(shader::exposureFromEv100(0.0), 1.0 / 1.2, 1e-15);
    EXPECT_NEAR(1.2 * 1024.0 * shader::exposureFromEv100(10.0), 1.0, 1e-12);
    EXPECT_TRUE(std::isfinite(shader_float::exposureFromEv100(-119.0F)));
    EXPECT_GT(shader_float::exposureFromEv100(119.0F), 0.0F);
}

TEST(Srgb, EncodesKnownValues) {
    EXPECT_NEAR(shader::srgbEncodeChannel(0.5), 0.735356983, 1e-8);
    EXPECT_NEAR(shader::srgbEncodeChannel(0.001), 0.01292, 1e-12);
    EXPECT_NEAR(shader::srgbDecodeChannel(128.0 / 255.0), 0.215860500, 1e-8);
    const glm::dvec3 encoded = shader::srgbEncode({0.0, 0.5, 1.0});
    EXPECT_EQ(encoded.x, 0.0);
    EXPECT_NEAR(encoded.y, 0.735356983, 1e-8);
    EXPECT_NEAR(encoded.z, 1.0, 1e-12);
    EXPECT_NEAR(shader::srgbEncodeChannel(7.0), 1.0, 1e-12);
    EXPECT_EQ(shader::srgbEncodeChannel(-7.0), 0.0);
}

TEST(Srgb, DecodingUndoesEncoding) {
    for (int i = 0; i <= 255; ++i) {
        const double code = i / 255.0;
        const glm::dvec3 there = shader::srgbDecode(glm::dvec3(code));
        // The two branches of the standard meet only to about 1e-7.
        EXPECT_NEAR(shader::srgbEncode(there).y, code, 1e-6);
    }
}

}  // namespace
}  // namespace ribalta
