// Where light maps let light through, and lamps narrowed to that.
#include "render/lit_region.h"

#include <cmath>
#include <cstring>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "reference/light_map_texture.h"
#include "render/lamp_reach.h"
#include "support/stage.h"

namespace ribalta::test {
namespace {

/// A white disc on black; centre and radius in half sides, y up.
Image disc(int side, const glm::dvec2& centre, double radius) {
    return makeImage(side, side, [&](int x, int y) {
        const glm::dvec2 at(2.0 * (x + 0.5) / side - 1.0, 1.0 - 2.0 * (y + 0.5) / side);
        return glm::length(at - centre) < radius ? glm::vec4(1.0F) : glm::vec4(0, 0, 0, 1);
    });
}

TEST(LitRegion, EnclosesTheLitTexelsClosely) {
    const LitRegion region = litRegion(disc(256, {0.2, -0.1}, 0.4));
    EXPECT_FALSE(region.isDark);
    EXPECT_NEAR(region.low.x, -0.2, 0.03);
    EXPECT_NEAR(region.high.x, 0.6, 0.03);
    EXPECT_NEAR(region.low.y, -0.5, 0.03);
    EXPECT_NEAR(region.high.y, 0.3, 0.03);
    EXPECT_NEAR(region.radius, 0.4 + std::hypot(0.2, 0.1), 0.04);
    EXPECT_LT(region.low.x, -0.2);
    EXPECT_GT(region.high.y, 0.3);
}

TEST(LitRegion, BlackIsDarkAndWhiteIsWhole) {
    EXPECT_TRUE(litRegion(disc(16, {0, 0}, 0.0)).isDark);
    const LitRegion white = litRegion(disc(16, {0, 0}, 9.0));
    EXPECT_EQ(white.low, glm::dvec2(-1.0));
    EXPECT_EQ(white.high, glm::dvec2(1.0));
    EXPECT_GE(white.radius, std::numbers::sqrt2);
}

TEST(LitRegion, OneFaintTexelOfAnyChannelCounts) {
    for (int channel = 0; channel < 3; ++channel) {
        Image image = disc(64, {0, 0}, 0.0);
        image.pixels[std::size_t(64 * 10 + 60) * 4 + std::size_t(channel)] = std::byte(1);
        const LitRegion region = litRegion(image);
        EXPECT_FALSE(region.isDark) << channel;
        EXPECT_GT(region.high.x, 2.0 * 61 / 64 - 1.0);
        EXPECT_GT(region.high.y, 1.0 - 2.0 * 10 / 64);
    }
    Image floats;
    floats.width = floats.height = 4;
    floats.type = Image::Type::kFloat32;
    floats.pixels = RawBytes(4 * 4 * 16, std::byte(0));
    EXPECT_TRUE(litRegion(floats).isDark);
    const float faint = 1e-30F;
    std::memcpy(&floats.pixels[16 * 5], &faint, sizeof faint);
    EXPECT_FALSE(litRegion(floats).isDark);
}

TEST(LitRegion, AMapThatIsNotKnownChangesNothing) {
    Scene scene;
    SpotLight lamp = makeSpot({0, 5, 0}, {0, 0, 0}, 0.3);
    useLightMap(scene, lamp, disc(64, {0, 0}, 0.3));
    EXPECT_EQ(litPart(lamp, {}).outerConeAngle, lamp.outerConeAngle);
    scene.spotLights.push_back(lamp);
    const SpotLight part = litPart(lamp, litRegions(scene));
    EXPECT_LT(std::tan(part.outerConeAngle), 0.5 * std::tan(0.3));
    EXPECT_GT(std::tan(part.outerConeAngle), 0.3 * std::tan(0.3));
}

TEST(LitRegion, AnAllBlackMapMakesADarkLamp) {
    Scene scene;
    scene.spotLights.push_back(makeSpot({0, 5, 0}, {0, 0, 0}, 0.3));
    useLightMap(scene, scene.spotLights[0], disc(64, {0, 0}, 0.0));
    EXPECT_FALSE(isDark(scene.spotLights[0]));
    EXPECT_TRUE(isDark(litPart(scene.spotLights[0], litRegions(scene))));
}

// Random discs, turned at random, on cones and pyramids: whatever direction light comes out in lies
// in the narrowed beam.
TEST(LitRegion, NeverCutsLight) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    int narrowed = 0;
    for (int i = 0; i < 400; ++i) {
        Scene scene;
        SpotLight lamp = makeSpot({0, 0, 0}, {0, 0, -1}, 0.05 + 1.3 * std::abs(any(random)));
        lamp.beamShape = i % 2 == 0 ? BeamShape::kCone : BeamShape::kPyramid;
        useLightMap(scene, lamp,
                    disc(8 << (i % 5), {0.6 * any(random), 0.6 * any(random)},
                         0.05 + 0.5 * std::abs(any(random))),
                    std::numbers::pi * any(random));
        scene.spotLights.push_back(lamp);
        const SpotLight part = litPart(lamp, litRegions(scene));
        const LightMapTexture map(scene.images[0]);
        const double tangent = std::tan(lamp.outerConeAngle);
        const double litTangent = std::tan(part.outerConeAngle) * (1.0 + 1e-12);
        narrowed += litTangent < 0.99 * tangent && part.intensityCandela > 0.0 ? 1 : 0;
        for (int p = 0; p < 500; ++p) {
            const glm::dvec2 slope = tangent * glm::dvec2(any(random), any(random));
            const bool pyramid = lamp.beamShape == BeamShape::kPyramid;
            const double out =
                pyramid ? std::max(std::abs(slope.x), std::abs(slope.y)) : glm::length(slope);
            const double c = std::cos(lamp.lightMap->rotationRadians);
            const double s = std::sin(lamp.lightMap->rotationRadians);
            const glm::dvec2 at =
                glm::dvec2(c * slope.x + s * slope.y, c * slope.y - s * slope.x) / tangent;
            const glm::dvec3 light = map.at({0.5 + 0.5 * at.x, 0.5 - 0.5 * at.y});
            if (out < tangent && light != glm::dvec3(0.0)) {
                ASSERT_LE(out, litTangent) << "case " << i;
                ASSERT_GT(part.intensityCandela, 0.0) << "case " << i;
            }
        }
    }
    EXPECT_GT(narrowed, 120);
}

}  // namespace
}  // namespace ribalta::test
