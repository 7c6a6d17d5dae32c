// The mappings of the precomputed sky's tables: places and rays are each other's inverse, in double
// and in single precision, and places stay within the tables whatever the planet.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "optics/shader_lib.h"
#include "shader_lib_float.h"

namespace ribalta {
namespace {

constexpr double kLowestSun = -0.2079117;

template <typename Air>
Air planet(double radius, double top) {
    Air air{};
    air.groundRadius = decltype(air.groundRadius)(radius);
    air.top = decltype(air.top)(top);
    air.rayleighHeight = 8000;
    air.mieHeight = 1200;
    return air;
}

class Places {
  public:
    /// Among them those of the tables' outermost texels.
    double next() {
        const double place = unit_(random_);
        return place < 0.05 ? 0.0 : place > 0.95 ? 1.0 : place;
    }

  private:
    std::mt19937_64 random_{3};
    std::uniform_real_distribution<double> unit_{0.0, 1.0};
};

TEST(SkyMapping, TexelsAndCoordinatesAreInverse) {
    for (const double texels : {2.0, 8.0, 32.0, 128.0}) {
        for (double texel = 0.0; texel < texels; ++texel) {
            EXPECT_NEAR(
                shader::textureCoordinate(shader::texelPlace(texel, texels), texels) * texels,
                texel + 0.5, 1e-12);
            if (texels >= 4.0) {
                const bool ground = texel < 0.5 * texels;
                EXPECT_NEAR(
                    shader::halvesCoordinate(shader::halvesPlace(texel, texels), texels, ground) *
                        texels,
                    texel + 0.5, 1e-12);
            }
        }
    }
    EXPECT_EQ(shader::texelPlace(0.0, 1.0), 0.0);
    EXPECT_EQ(shader::textureCoordinate(0.7, 1.0), 0.5);
    // Nothing is read from the other half.
    EXPECT_LE(shader::halvesCoordinate(0.0, 128.0, true), 63.5 / 128.0);
    EXPECT_GE(shader::halvesCoordinate(0.0, 128.0, false), 64.5 / 128.0);
}

TEST(SkyMapping, TransmittanceThereAndBack) {
    Places places;
    for (const auto& air : {planet<shader::Air>(6.36e6, 60e3), planet<shader::Air>(4e5, 60e3)}) {
        for (int i = 0; i < 5000; ++i) {
            const glm::dvec2 place(places.next(), places.next());
            double h = 0.0;
            double mu = 0.0;
            shader::transmittanceRay(air, place, h, mu);
            EXPECT_FALSE(shader::hitsGround(air, h, mu + 1e-9)) << h << " " << mu;
            const glm::dvec2 back = shader::transmittancePlace(air, h, mu);
            EXPECT_NEAR(back.x, place.x, 1e-7);
            EXPECT_NEAR(back.y, place.y, 1e-9);

            shader::transmittanceRay2008(air, place, h, mu);
            const glm::dvec2 back2008 = shader::transmittancePlace2008(air, h, mu);
            EXPECT_NEAR(back2008.x, place.x, 1e-12);
            EXPECT_NEAR(back2008.y, place.y, 1e-12);
        }
    }
}

struct SkyRay {
    double h = 0.0;
    double mu = 0.0;
    double muS = 0.0;
    double nu = 0.0;
};

/// `back` of the ray of a place is the place; nu aside, where three directions allow no such nu.
void expectBack(const glm::dvec4& place, const SkyRay& ray, const glm::dvec4& back) {
    EXPECT_NEAR(back.x, place.x, 1e-9) << ray.muS;
    EXPECT_NEAR(back.y, place.y, 1e-6) << ray.h << " " << ray.mu;
    EXPECT_NEAR(back.z, place.z, 1e-9) << ray.h;
    EXPECT_NEAR(2.0 * back.w - 1.0, ray.nu, 1e-12);
    const double sines = std::sqrt((1.0 - ray.mu * ray.mu) * (1.0 - ray.muS * ray.muS));
    const double wanted = 2.0 * place.w - 1.0;
    if (std::abs(wanted - ray.mu * ray.muS) < sines) {
        EXPECT_NEAR(ray.nu, wanted, 1e-12);
    }
}

TEST(SkyMapping, ScatteringThereAndBack) {
    Places places;
    for (const auto& air : {planet<shader::Air>(6.36e6, 60e3), planet<shader::Air>(4e5, 60e3)}) {
        for (int i = 0; i < 10000; ++i) {
            const glm::dvec4 place(places.next(), places.next(), places.next(), places.next());
            const bool ground = i % 2 == 0;
            SkyRay ray;
            shader::scatteringRay(air, kLowestSun, place, ground, ray.h, ray.mu, ray.muS, ray.nu);
            glm::dvec4 back =
                shader::scatteringPlace(air, kLowestSun, ray.h, ray.mu, ray.muS, ray.nu, ground);
            // On the ground itself there is but one way down.
            if (ground && ray.h < 1e-6) {
                back.y = place.y;
            }
            expectBack(place, ray, back);

            shader::scatteringRay2008(air, place, ground, ray.h, ray.mu, ray.muS, ray.nu);
            back = shader::scatteringPlace2008(air, ray.h, ray.mu, ray.muS, ray.nu, ground);
            // Places that stand for no way have the shortest one's ray.
            if (place.x < 6e-4) {
                back.x = place.x;  // its suns are cut off a little before 0
            }
            if (shader::shortOfWay2008(air, ray.h, place.y, ground) < 1.0 || ray.h < 1e-6) {
                back.y = place.y;
            }
            expectBack(place, ray, back);
        }
    }
}

TEST(SkyMapping, SunsBelowTheLowestCountAsIt) {
    const auto air = planet<shader::Air>(6.36e6, 60e3);
    EXPECT_EQ(shader::sunPlace(air, kLowestSun, -1.0), 0.0);
    EXPECT_NEAR(shader::sunPlace(air, kLowestSun, kLowestSun), 0.0, 1e-12);
    EXPECT_NEAR(shader::sunPlace(air, kLowestSun, 1.0), 1.0, 1e-12);
    EXPECT_NEAR(shader::sunPlace2008(-1.0), 0.0, 1e-3);
    EXPECT_NEAR(shader::sunPlace2008(1.0), 1.0, 1e-12);
    double before = -1.0;
    for (double muS = kLowestSun; muS <= 1.0; muS += 1e-3) {
        const double place = shader::sunPlace(air, kLowestSun, muS);
        EXPECT_GT(place, before);
        before = place;
    }
}

// What a shader does with any ray that it may meet.
TEST(SkyMapping, SinglesStayWithinTheTables) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<float> unit(0.0F, 1.0F);
    for (const auto& [radius, top] :
         {std::pair(6.36e6, 60e3), std::pair(4e5, 60e3), std::pair(1e9, 100.0)}) {
        const auto air = planet<shader_float::Air>(radius, top);
        for (int i = 0; i < 20000; ++i) {
            const float h = i % 5 == 0   ? 0.0F
                            : i % 5 == 1 ? air.top
                                         : air.top * std::pow(unit(random), 4.0F);
            const float level = -std::sqrt(2.0F * h / air.groundRadius);
            const float mu = i % 7 == 0   ? -1.0F
                             : i % 7 == 1 ? 1.0F
                             : i % 7 == 2 ? 0.0F
                             : i % 7 == 3 ? std::max(level + 1e-4F * (unit(random) - 0.5F), -1.0F)
                                          : 2.0F * unit(random) - 1.0F;
            const float muS = i % 11 == 0 ? -1.0F : i % 11 == 1 ? 1.0F : 2.0F * unit(random) - 1.0F;
            const float nu = shader_float::possibleNu(mu, muS, 2.0F * unit(random) - 1.0F);
            const bool ground = shader_float::hitsGround(air, h, mu);
            const glm::vec2 planes[] = {shader_float::transmittancePlace(air, h, mu),
                                        shader_float::transmittancePlace2008(air, h, mu)};
            for (const glm::vec2& place : planes) {
                for (int k = 0; k < 2; ++k) {
                    EXPECT_TRUE(place[k] >= 0.0F && place[k] < 1.0001F) << h << " " << mu;
                }
            }
            const glm::vec4 volumes[] = {
                shader_float::scatteringPlace(air, float(kLowestSun), h, mu, muS, nu, ground),
                shader_float::scatteringPlace2008(air, h, mu, muS, nu, ground)};
            for (const glm::vec4& place : volumes) {
                for (int k = 0; k < 4; ++k) {
                    EXPECT_TRUE(place[k] >= 0.0F && place[k] < 1.0001F)
                        << h << " " << mu << " " << muS << " " << k;
                }
            }
        }
    }
}

TEST(SkyMapping, SinglesComeBackToTheirTexel) {
    const auto air = planet<shader_float::Air>(6.36e6, 60e3);
    for (int z = 0; z < 32; ++z) {
        for (int y = 0; y < 128; ++y) {
            for (int x = 0; x < 32; ++x) {
                const bool ground = y < 64;
                const glm::vec4 place(float(x) / 31.0F, shader_float::halvesPlace(float(y), 128.0F),
                                      float(z) / 31.0F, 0.5F);
                float h = 0.0F;
                float mu = 0.0F;
                float muS = 0.0F;
                float nu = 0.0F;
                shader_float::scatteringRay(air, float(kLowestSun), place, ground, h, mu, muS, nu);
                const glm::vec4 back =
                    shader_float::scatteringPlace(air, float(kLowestSun), h, mu, muS, nu, ground);
                EXPECT_NEAR(back.x * 31.0F, float(x), 2e-3F) << muS;
                EXPECT_NEAR(back.z * 31.0F, float(z), 2e-3F) << h;
                if (!ground || z > 0) {
                    // A bit of mu is much of the way near the horizon, which singles do not tell.
                    EXPECT_NEAR(back.y * 63.0F, place.y * 63.0F, 0.5F) << h << " " << mu;
                }
            }
        }
    }
}

}  // namespace
}  // namespace ribalta
