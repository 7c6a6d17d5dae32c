// The tables a renderer draws the sky from, against the reference.
#include "sky/sky_tables.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/angles.h"
#include "optics/shader_lib.h"
#include "reference/integrate_sky.h"
#include "sky/sky_air.h"
#include "support/strange_airs.h"

namespace ribalta {
namespace {

const SkyTables& fourOrders() {
    static const SkyTables tables(Atmosphere{}, {4, false});
    return tables;
}

TEST(SkyTables, AreAsLargeAsTheShadersExpect) {
    const std::size_t sources = std::size_t(shader::kSourceHeights) * shader::kSourceAzimuths *
                                shader::kSourceZeniths * shader::kSourceSuns;
    EXPECT_EQ(fourOrders().rayleighSources().size(), sources);
    EXPECT_EQ(fourOrders().mieSources().size(), sources);
    EXPECT_EQ(fourOrders().groundIrradiance().size(), std::size_t(shader::kSourceSuns));
    EXPECT_EQ(fourOrders().opticalLengths().size(),
              std::size_t(shader::kLengthHeights) * shader::kLengthCosines);
}

TEST(SkyTables, OneOrderNeedsNoSources) {
    const SkyTables tables(Atmosphere{}, {1, false});
    EXPECT_TRUE(tables.rayleighSources().empty());
    EXPECT_TRUE(tables.mieSources().empty());
    EXPECT_TRUE(tables.groundIrradiance().empty());
    EXPECT_GT(tables.irradianceAt(0.0, 0.5).up.z, 0.0);
    EXPECT_LT(tables.irradianceAt(0.0, 0.5).up.z, fourOrders().irradianceAt(0.0, 0.5).up.z);
}

TEST(SkyTables, TheGroundIsLitAsInTheReference) {
    const double suns[] = {1.0, 0.5, 0.1, 0.0, -0.07};
    std::vector<SkyRay> rays;
    for (const double muS : suns) {
        rays.push_back({0.0, -1.0, muS, -muS});
    }
    SkySettings settings;
    settings.exactSecondOrder = false;
    settings.tables = coarseSkyTables();
    const SkyIntegrator exact(Atmosphere{}, settings, rays);
    for (const double muS : suns) {
        glm::dvec3 expected(0.0);
        for (int order = 1; order < 4; ++order) {
            expected += exact.irradiance(order, muS);
        }
        const double place =
            shader::sourceSun(fourOrders().suns(), muS);  // between two suns, linear in logarithms
        const auto first = std::size_t(std::min(place, shader::kSourceSuns - 2.0));
        const auto& table = fourOrders().groundIrradiance();
        const glm::dvec3 logs =
            glm::mix(glm::dvec3(table[first]), glm::dvec3(table[first + 1]), place - double(first));
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(std::exp(logs[c]) / expected[c], 1.0, muS < 0.0 ? 4e-2 : 5e-3)
                << muS << " " << c;
        }
    }
}

TEST(SkyTables, LooksUpAtTheSkyAndDownAtTheGround) {
    const SkyIrradiance light = fourOrders().irradianceAt(0.0, 0.5);
    for (int c = 0; c < 3; ++c) {
        // On the ground itself all that comes from below is what it reflects of sun and sky.
        const glm::dvec3 sun = fourOrders().sunlight(0.0, 0.5);
        EXPECT_NEAR(light.down[c] / (0.1 * (0.5 * sun[c] + light.up[c])), 1.0, 0.02) << c;
        EXPECT_GT(light.towardsSun[c], light.across[c]) << c;
        EXPECT_GT(light.across[c], light.awayFromSun[c] * 0.9) << c;
    }
}

TEST(SkyTables, TheSunSetsBitByBit) {
    double before = -1.0;
    int between = 0;
    for (double elevation = -2.0; elevation <= 2.0; elevation += 0.01) {
        const double light = fourOrders().sunlight(2.0, std::sin(elevation * kDegree)).x;
        EXPECT_GE(light, before) << elevation;
        EXPECT_LT(light - std::max(before, 0.0), 0.02) << elevation;
        between += light > 0.0 && light < 0.1 ? 1 : 0;
        before = light;
    }
    EXPECT_GT(between, 10);
    EXPECT_EQ(fourOrders().sunlight(2.0, std::sin(-0.4 * kDegree)), glm::dvec3(0.0));
}

TEST(SkyTables, AboveTheAirTheSunIsWhole) {
    EXPECT_EQ(fourOrders().sunlight(400e3, 0.3), glm::dvec3(1.0));
    const double limb = fourOrders().sunlight(400e3, std::sin(-19.0 * kDegree)).x;
    EXPECT_GT(limb, 0.3) << "through the thin air past the limb";
    EXPECT_LT(limb, 1.0);
    EXPECT_EQ(fourOrders().sunlight(400e3, std::sin(-25.0 * kDegree)), glm::dvec3(0.0));
}

TEST(SkyTables, TheRestOfTheSeriesIsAlmostAllThatIsMissing) {
    const SkyTables closed(Atmosphere{}, {4, true});
    const SkyTables eight(Atmosphere{}, {8, false});
    const glm::dvec3 four = fourOrders().irradianceAt(0.0, 0.5).up;
    const glm::dvec3 all = closed.irradianceAt(0.0, 0.5).up;
    const glm::dvec3 more = eight.irradianceAt(0.0, 0.5).up;
    for (int c = 0; c < 3; ++c) {
        EXPECT_GT(all[c], four[c]);
        EXPECT_NEAR(all[c] / more[c], 1.0, 1e-3) << c;
    }
}

TEST(SkyTables, StrangeAirIsStillAir) {
    std::vector<Atmosphere> airs = test::strangeAirs();
    airs.push_back(withoutMie(Atmosphere{}));
    for (const Atmosphere& air : airs) {
        const SkyTables tables(air, {4, true});
        for (const auto* table :
             {&tables.rayleighSources(), &tables.mieSources(), &tables.groundIrradiance()}) {
            for (const glm::vec4& value : *table) {
                ASSERT_TRUE(std::isfinite(value.x + value.y + value.z));
                ASSERT_LT(std::max({value.x, value.y, value.z}), std::log(10.0F));
            }
        }
    }
}

}  // namespace
}  // namespace ribalta
