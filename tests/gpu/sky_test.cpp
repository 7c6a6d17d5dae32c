// The sky as the GPU computes it, along listed rays and in pictures, against the reference; and at
// extremes.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "base/angles.h"
#include "base/parallel_for.h"
#include "gl/counters.h"
#include "gpu_test.h"
#include "reference/integrate_sky.h"
#include "render/evaluate_sky.h"
#include "support/stage.h"
#include "support/strange_airs.h"

namespace ribalta::test {
namespace {

constexpr double kDarkest = 1e-6;  // radiance from which on a relative error counts

/// A ray that looks at azimuth `around` from the sun's; angles in radians.
SkyRay rayByAngles(double height, double zenithAngle, double elevation, double around) {
    const double mu = std::cos(zenithAngle);
    const double muS = std::sin(elevation);
    return {height, mu, muS,
            mu * muS + std::sin(zenithAngle) * std::cos(elevation) * std::cos(around)};
}

std::vector<SkyRay> randomRays(int count, double lowestSun, double highestSun) {
    std::mt19937 engine(11);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine);
    };
    const double heights[] = {0.0, 2.0, 100.0, 2e3, 10e3, 50e3, 60e3, 400e3};
    std::vector<SkyRay> rays;
    for (int i = 0; i < count; ++i) {
        const double height = heights[std::size_t(i) % std::size(heights)];
        // In space: towards the planet and its limb.
        const double lowest = height > 60e3 ? 105.0 : 0.0;
        rays.push_back(rayByAngles(height, between(lowest, 180.0) * kDegree,
                                   between(lowestSun, highestSun) * kDegree,
                                   between(0.0, std::numbers::pi)));
    }
    return rays;
}

class Errors {
  public:
    void add(const glm::dvec3& got, const glm::dvec3& right, double darkest = kDarkest) {
        for (int c = 0; c < 3; ++c) {
            EXPECT_GE(got[c], 0.0);
            if (right[c] > darkest) {
                errors_.push_back(std::abs(got[c] / right[c] - 1.0));
            }
        }
    }
    /// Bounds of the median, of 90, 95 and 100 % of the errors.
    void expectBelow(const std::array<double, 4>& bounds) {
        ASSERT_GT(errors_.size(), 10U);
        std::sort(errors_.begin(), errors_.end());
        const double shares[] = {0.5, 0.9, 0.95, 1.0};
        for (std::size_t i = 0; i < bounds.size(); ++i) {
            const auto place = std::size_t(shares[i] * double(errors_.size() - 1));
            EXPECT_LT(errors_[place], bounds[i]) << 100.0 * shares[i] << " % of the errors";
        }
    }

  private:
    std::vector<double> errors_;
};

std::vector<SkyLight> integrate(const SkySettings& settings, const std::vector<SkyRay>& rays) {
    const SkyIntegrator exact(Atmosphere{}, settings, rays);
    std::vector<SkyLight> lights(rays.size());
    parallelFor(rays.size(), [&](std::size_t i) { lights[i] = exact.along(rays[i]); });
    return lights;
}

class Sky : public GpuTest {};

TEST_F(Sky, LightScatteredOnceIsTheReferences) {
    SkySettings settings;
    settings.orders = 1;
    const std::vector<SkyRay> rays = randomRays(400, -6.0, 90.0);
    const std::vector<SkyLight> exact = integrate(settings, rays);
    const std::vector<SkyLight> got = evaluateSky(Atmosphere{}, {1, false}, rays);
    Errors air;
    Errors through;
    Errors ground;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        air.add(got[i].air, exact[i].air);
        through.add(got[i].transmittance, exact[i].transmittance, 0.0);
        ground.add(got[i].ground, exact[i].ground);
    }
    air.expectBelow({2e-4, 2e-3, 6e-3, 5e-2});
    through.expectBelow({1e-4, 1e-3, 1e-3, 3e-3});
    ground.expectBelow({1e-4, 1e-3, 1e-3, 3e-3});
}

TEST_F(Sky, FourOrdersAreTheReferences) {
    SkySettings settings;
    settings.exactSecondOrder = false;
    settings.tables = coarseSkyTables();
    for (const bool dusk : {false, true}) {
        const std::vector<SkyRay> rays =
            dusk ? randomRays(60, -4.0, -3.9) : randomRays(100, 0.0, 90.0);
        const std::vector<SkyLight> exact = integrate(settings, rays);
        const std::vector<SkyLight> got = evaluateSky(Atmosphere{}, {4, false}, rays);
        Errors all;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            all.add(got[i].air + got[i].ground, exact[i].air + exact[i].ground);
        }
        if (dusk) {
            all.expectBelow({5e-3, 3e-2, 6e-2, 1e-1});
        } else {
            all.expectBelow({5e-3, 1e-2, 2e-2, 5e-2});
        }
    }
}

TEST_F(Sky, AirBetweenTwoPointsIsTheReferences) {
    SkySettings settings;
    settings.orders = 1;
    std::vector<SkyRay> rays = randomRays(200, 0.0, 90.0);
    std::erase_if(rays, [](const SkyRay& ray) { return ray.heightMetres > 60e3; });
    const double ways[] = {50.0, 300.0, 2e3, 10e3, 60e3};
    for (std::size_t i = 0; i < rays.size(); ++i) {
        rays[i].distanceMetres = ways[i % std::size(ways)];
    }
    const std::vector<SkyLight> exact = integrate(settings, rays);
    const std::vector<SkyLight> got = evaluateSky(Atmosphere{}, {1, false}, rays);
    Errors errors;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        errors.add(got[i].air, exact[i].air, 1e-12);
    }
    errors.expectBelow({1e-5, 2e-3, 2e-3, 1e-2});
}

TEST_F(Sky, ExtremesAreFiniteAndNotNegative) {
    std::vector<Atmosphere> airs = strangeAirs();
    airs.emplace_back();
    std::vector<SkyRay> rays;
    for (const double height : {0.0, 1e-3, 2.0, 60e3 - 1e-3, 60e3, 60e3 + 1e-3, 400e3, 12e6}) {
        for (const double angle : {0.0, 45.0, 89.99, 90.0, 90.01, 91.0, 110.1, 135.0, 180.0}) {
            for (const double sun : {-90.0, -20.0, -4.0, -0.01, 0.0, 0.01, 5.0, 90.0}) {
                for (const double around : {0.0, 90.0, 180.0}) {
                    rays.push_back(
                        rayByAngles(height, angle * kDegree, sun * kDegree, around * kDegree));
                }
            }
        }
    }
    for (const Atmosphere& air : airs) {
        for (const SkyLight& light : evaluateSky(air, {4, true}, rays)) {
            for (const glm::dvec3& value : {light.transmittance, light.air, light.ground}) {
                for (int c = 0; c < 3; ++c) {
                    ASSERT_TRUE(std::isfinite(value[c]));
                    ASSERT_GE(value[c], 0.0);
                }
            }
        }
    }
}

TEST_F(Sky, TablesTakeATenthOfTheThesiss) {
    Scene scene;
    addShape(scene, makeQuad({0, 0, 0}, {5, 0, 0}, {0, 0, -5}), makeMaterial(glm::vec3(0.5F)));
    FrameSettings settings = measuringSettings();
    const auto bytesFor = [&] {
        const std::uint64_t before = glCounters().bytesAllocated;
        Renderer renderer(scene);
        renderer.draw(makeCamera({0, 2, 8}, {0, 1, 0}), settings);
        return glCounters().bytesAllocated - before;
    };
    const std::uint64_t without = bytesFor();
    settings.sky.emplace();
    settings.sky->towardsSun = {std::cos(-0.1), std::sin(-0.1), 0.0};  // down: no shadow maps
    const std::uint64_t with = bytesFor();
    EXPECT_GT(with, without);
    EXPECT_LT(with - without, 1444U * 1024U);
}

// Pictures of light scattered once, as the reference gives that to the bit.
class SkyPicture : public Sky {
  protected:
    SkyPicture() {
        settings_ = measuringSettings();
        settings_.sky.emplace();
        settings_.sky->orders = {1, false};
    }

    void lookAt(double elevation, const glm::dvec3& from, const glm::dvec3& target) {
        camera_ = makeCamera(from, target, 1.2);
        settings_.sky->towardsSun = {std::cos(elevation * kDegree), std::sin(elevation * kDegree),
                                     0.0};
    }
    SkyRay rayOf(int x, int y, double metresOfDepth) const {
        const PixelRay pixel = pixelRay(camera_, settings_.width, settings_.height, x, y);
        const SkyEye eye = skyEye(*settings_.sky, camera_.frame.position);
        SkyRay ray{eye.heightMetres, glm::dot(pixel.direction, eye.zenith), eye.muS,
                   glm::dot(pixel.direction, settings_.sky->towardsSun)};
        if (metresOfDepth > 0.0) {
            ray.distanceMetres = metresOfDepth * pixel.metresPerDepth;
        }
        return ray;
    }
    /// Every few pixels of a picture; the sun's own disc aside.
    void expectPicture(const std::array<double, 4>& bounds) {
        const Frame3 frame = drawOnce(scene_, camera_, settings_, {.depth = true});
        EXPECT_EQ(countNotFinite(frame), 0);
        const SkyIntegrator exact(Atmosphere{}, {.orders = 1}, {});
        const double lux = Atmosphere{}.sunIlluminanceLux.x;
        Errors errors;
        for (int y = 0; y < settings_.height; y += 3) {
            for (int x = 0; x < settings_.width; x += 5) {
                const double depth = frame.depth(x, y);
                const SkyRay ray = rayOf(x, y, std::isfinite(depth) ? depth : 0.0);
                // A surface below the planet's ground is drawn; the reference's rays end before.
                const std::optional<AirPath> path = airPath(Atmosphere{}, ray);
                const bool beyond = std::isfinite(depth) && path && path->endsOnGround;
                if (ray.nu < std::cos(2.0 * kDegree) && !beyond) {
                    const SkyLight light = exact.along(ray);
                    errors.add(frame.color(x, y) / lux, light.air + light.ground);
                }
            }
        }
        errors.expectBelow(bounds);
    }

    Scene scene_;
    Camera camera_;
    FrameSettings settings_;
};

TEST_F(SkyPicture, SkyAndGroundAreTheReferences) {
    for (const double elevation : {60.0, 20.0, 5.0, 0.0, -4.0}) {
        SCOPED_TRACE(elevation);
        lookAt(elevation, {0, 2, 0}, {1, 2.2, 0.4});
        if (elevation > 1.0) {
            expectPicture({1e-3, 3e-3, 4e-3, 1e-2});
        } else {
            expectPicture({2e-3, 8e-3, 1.2e-2, 6e-2});
        }
    }
}

TEST_F(SkyPicture, FromSpaceToo) {
    lookAt(20.0, {0, 400e3, 0}, {1, 400e3 - 0.4, 0.4});
    expectPicture({1e-3, 4e-3, 8e-3, 1e-1});
}

// From within the shadow, just below its edge, which rises out of the air opposite to the sun: blue
// light falls from 2e-4 to nothing within a degree.
TEST_F(SkyPicture, TheEdgeOfThePlanetsShadowIsAsSharpAsTheReferences) {
    lookAt(-2.6826, {0, 4997, 0}, {-1, 4997.06, 0.09});
    camera_ = makeCamera(camera_.frame.position, {-1, 4997.06, 0.09}, 0.15);
    const Frame3 frame = drawOnce(scene_, camera_, settings_);
    // What is before it dims it alone, once.
    Material glass = makeMaterial(glm::vec3(0.0F));
    glass.unlit = true;
    glass.baseColor.w = 0.25F;
    glass.alphaMode = Material::AlphaMode::kBlend;
    glass.doubleSided = true;
    addShape(scene_, makeQuad({-2, 4997, 0}, {0, 0, 9}, {0, 9, 0}), glass);
    const Frame3 dimmed = drawOnce(scene_, camera_, settings_);
    const SkyIntegrator exact(Atmosphere{}, {.orders = 1}, {});
    const double lux = Atmosphere{}.sunIlluminanceLux.x;
    double darkest = 1.0;
    double brightest = 0.0;
    for (int y = 0; y < settings_.height; ++y) {
        for (int x = 0; x < settings_.width; x += 9) {
            const glm::dvec3 right = exact.along(rayOf(x, y, 0.0)).air;
            const glm::dvec3 got = frame.color(x, y) / lux;
            darkest = std::min(darkest, right.z);
            brightest = std::max(brightest, right.z);
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(got[c], right[c], 0.03 * right[c] + 3e-6) << x << ", " << y;
                EXPECT_NEAR(dimmed.color(x, y)[c] / lux, 0.75 * got[c], 1e-3 * got[c] + 1e-9);
            }
        }
    }
    EXPECT_LT(darkest, 1e-8);
    EXPECT_GT(brightest, 1e-4);
}

TEST_F(SkyPicture, AirBeforeSurfacesIsTheReferences) {
    for (const double metres : {50.0, 1e3, 10e3, 60e3}) {
        SCOPED_TRACE(metres);
        scene_ = {};
        // Black, so that only the air before it is seen.
        const auto side = float(2.0 * metres);
        addShape(scene_, makeQuad({float(metres), 0, 0}, {0, 0, side}, {0, side, 0}),
                 makeMaterial(glm::vec3(0.0F)));
        scene_.materials.back().unlit = true;
        for (const double elevation : {60.0, 5.0}) {
            lookAt(elevation, {0, 2, 0}, {1, 2.3, 0});
            if (metres < 20e3) {
                expectPicture({5e-4, 1.5e-3, 2e-3, 5e-3});
            } else {
                expectPicture({2e-3, 8e-3, 1e-2, 4e-2});
            }
        }
    }
}

TEST_F(SkyPicture, TheSunsDiscBringsTheSunsLight) {
    // All of the disc's pixels together are the sun's irradiance, what the air takes aside.
    lookAt(30.0, {0, 2, 0}, {std::cos(30.0 * kDegree), 2.0 + std::sin(30.0 * kDegree), 0});
    camera_ = makeCamera({0, 2, 0}, camera_.frame.position + settings_.sky->towardsSun, 0.02);
    settings_.width = 96;
    settings_.height = 96;
    const Frame3 frame = drawOnce(scene_, camera_, settings_);
    const double pixel = 2.0 * std::tan(0.01) / 96.0;
    glm::dvec3 sum(0.0);
    for (int y = 0; y < 96; ++y) {
        for (int x = 0; x < 96; ++x) {
            sum += frame.color(x, y) * pixel * pixel;
        }
    }
    const SkyRay ray{2.0, 0.5, 0.5, 1.0};
    const SkyIntegrator exact(Atmosphere{}, {.orders = 1}, {});
    const glm::dvec3 expected = Atmosphere{}.sunIlluminanceLux * exact.transmittanceAlong(ray);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(sum[c] / expected[c], 1.0, 0.03) << c;
    }
    // Limb darkening: dimmer near the edge, and bluer light most.
    const glm::dvec3 middle = frame.color(48, 48);
    const glm::dvec3 edge = frame.color(48 + int(0.85 * 0.004653 / pixel), 48);
    EXPECT_LT(edge.x, 0.9 * middle.x);
    EXPECT_LT(edge.z / middle.z, edge.x / middle.x);
}

TEST_F(SkyPicture, SurfacesAreLitBySunAndSky) {
    settings_.sky->orders = {4, true};
    addShape(scene_, makeQuad({0, 0, 0}, {50, 0, 0}, {0, 0, -50}), makeMaterial(glm::vec3(0.5F)));
    lookAt(40.0, {0, 3, 0.1}, {0, 0, 0});
    const SkyTables tables(Atmosphere{}, {4, true});
    const double muS = std::sin(40.0 * kDegree);
    const glm::dvec3 lux = Atmosphere{}.sunIlluminanceLux *
                           (muS * tables.sunlight(0.0, muS) + tables.irradianceAt(0.0, muS).up);
    const Frame3 frame = drawOnce(scene_, camera_, settings_);
    const glm::dvec3 middle = frame.color(32, 24);
    for (int c = 0; c < 3; ++c) {
        // A rough surface reflects a little more than its base colour.
        EXPECT_NEAR(middle[c] / (0.5 / std::numbers::pi * lux[c]), 1.05, 0.08) << c;
    }
    EXPECT_GT(middle.x, middle.z) << "the sun's light is yellow";
}

TEST_F(SkyPicture, WhatIsSeeThroughShowsTheSkyBehindIt) {
    lookAt(30.0, {0, 2, 0}, {1, 2.2, 0.4});
    const glm::dvec3 sky = drawOnce(scene_, camera_, settings_).color(32, 24);
    Material glass = makeMaterial(glm::vec3(0.0F));
    glass.unlit = true;
    glass.baseColor.w = 0.25F;
    glass.alphaMode = Material::AlphaMode::kBlend;
    glass.doubleSided = true;
    addShape(scene_, makeQuad({2, 2, 0}, {0, 0, 9}, {0, 9, 0}), glass);
    const glm::dvec3 through = drawOnce(scene_, camera_, settings_).color(32, 24);
    EXPECT_NEAR(through.z / sky.z, 0.75, 1e-3);
}

TEST_F(SkyPicture, NoSkyMakesNothing) {
    addShape(scene_, makeQuad({0, 0, 0}, {5, 0, 0}, {0, 0, -5}), makeMaterial(glm::vec3(0.5F)));
    lookAt(30.0, {0, 2, 8}, {0, 1, 0});
    FrameSettings indoors = settings_;
    indoors.sky.reset();
    const auto made = [&](const FrameSettings& settings) {
        const GlCounters before = glCounters();
        Renderer renderer(scene_);
        renderer.draw(camera_, settings);
        return std::array{glCounters().programsBuilt - before.programsBuilt,
                          glCounters().texturesMade - before.texturesMade,
                          glCounters().drawCalls - before.drawCalls};
    };
    const auto without = made(indoors);
    const auto with = made(settings_);
    EXPECT_EQ(without[0], 1U) << "surfaces";
    EXPECT_EQ(without[2], 1U);
    // The view's table, the air's, what puts them together, and the sun's shadows.
    EXPECT_EQ(with[0] - without[0], 4U);
    EXPECT_EQ(with[1] - without[1], 4U) << "and the optical lengths, for one order";
    EXPECT_EQ(with[2] - without[2], 4U);
    settings_.sky->towardsSun = {std::cos(-0.1), std::sin(-0.1), 0.0};
    const auto night = made(settings_);
    // None of those while the sun is down, but where the planet's own shadow ends, and what draws
    // the sky there.
    EXPECT_EQ(night[0] - without[0], 5U);
    EXPECT_EQ(with[1] - night[1], 1U);
    EXPECT_EQ(night[2] - without[2], 5U);
}

}  // namespace
}  // namespace ribalta::test
