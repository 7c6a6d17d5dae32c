// The sky of reference pictures against the integral along single rays, and its daylight by sums
// that must be so.
#include "reference/sky_sight.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "base/angles.h"
#include "image/write_image.h"
#include "reference/integrate_sky.h"
#include "reference/reference_file.h"
#include "reference/reference_picture.h"
#include "reference/sky_daylight.h"
#include "support/expect_error.h"
#include "support/stage.h"
#include "support/test_folder.h"

namespace ribalta {
namespace {

SkyOverScene skyAt(double elevation, const SkyOrders& orders) {
    SkyOverScene sky;
    sky.orders = orders;
    sky.towardsSun = {std::cos(elevation * kDegree), std::sin(elevation * kDegree), 0.0};
    return sky;
}

std::vector<glm::dvec3> directions() {
    std::vector<glm::dvec3> all;
    for (const double up : {-0.6, -0.05, 0.01, 0.3, 0.95}) {
        for (const double around : {0.3, 1.9}) {
            const double across = std::sqrt(1.0 - up * up);
            all.emplace_back(across * std::cos(around), up, across * std::sin(around));
        }
    }
    return all;
}

double relativeOff(const glm::dvec3& got, const glm::dvec3& right) {
    const glm::dvec3 off = glm::abs(got - right);
    return std::max({off.x, off.y, off.z}) / std::max({right.x, right.y, right.z});
}

TEST(SkySight, LightScatteredOnceIsTheIntegrals) {
    const SkyIntegrator exact(Atmosphere(), {.orders = 1}, {});
    for (const double elevation : {40.0, 1.0, -3.0}) {
        const SkySight sight(skyAt(elevation, {1, false}));
        for (const double height : {2.0, 59e3, 400e3}) {
            for (const glm::dvec3& direction : directions()) {
                SkyRay ray = sight.ray({0.0, height, 0.0}, direction);
                for (const double metres : {std::numeric_limits<double>::infinity(), 5e3}) {
                    ray.distanceMetres = metres;
                    const SkyLight right = exact.along(ray);
                    const SkyLight got = sight.along(ray);
                    if (right.air.x > 1e-9) {
                        EXPECT_LT(relativeOff(got.air, right.air), 1e-4);
                        EXPECT_LT(relativeOff(got.transmittance, right.transmittance), 1e-9);
                    }
                    if (right.ground.x > 1e-9) {
                        EXPECT_LT(relativeOff(got.ground, right.ground), 1e-4);
                    }
                }
            }
        }
    }
}

TEST(SkySight, TheSecondOrderIsTheIntegralsAndTheErrorSaysHowFar) {
    const SkySight sight(skyAt(15.0, {2, false}));
    std::vector<SkyRay> rays;
    for (const glm::dvec3& direction : directions()) {
        rays.push_back(sight.ray({0.0, 2.0, 0.0}, direction));
    }
    const SkyError said = sight.errorOf(rays);
    EXPECT_LT(said.largest, 5e-3);
    EXPECT_LE(said.rms, said.largest);
    EXPECT_GT(said.rms, 0.0);
    const SkyIntegrator exact(Atmosphere(), {.orders = 2}, {});
    for (std::size_t i = 0; i < rays.size(); i += 3) {
        EXPECT_LE(relativeOff(sight.along(rays[i]).air, exact.along(rays[i]).air), said.largest);
    }
}

TEST(SkySight, AirAddsUpAlongARay) {
    const SkySight sight(skyAt(15.0, {1, false}));
    const glm::dvec3 from(0.0, 100.0, 0.0);
    const glm::dvec3 direction = glm::normalize(glm::dvec3(1.0, 0.05, 0.3));
    const glm::dvec3 behind = sight.behind(from, direction, 1e-3);
    // What is seen from 8 km on, through the air before it.
    const glm::dvec3 there = from + 8e3 * direction;
    const glm::dvec3 whole =
        sight.throughAir(sight.behind(there, direction, 1e-3), from, direction, 8e3);
    EXPECT_LT(relativeOff(whole, behind), 1e-5);
    EXPECT_LT(relativeOff(sight.throughAir({1.0, 2.0, 3.0}, from, direction, 1e-6), {1, 2, 3}),
              1e-5);
}

TEST(SkySight, TheDiscHoldsTheSunsLight) {
    const SkyOverScene sky = skyAt(30.0, {1, false});
    const SkySight sight(sky);
    const glm::dvec3 up(-sky.towardsSun.y, sky.towardsSun.x, 0.0);
    const double step = 1e-4;
    glm::dvec3 sum(0.0);
    for (int i = -60; i <= 60; ++i) {
        for (int j = -60; j <= 60; ++j) {
            const glm::dvec3 direction =
                glm::normalize(sky.towardsSun + step * i * up + step * j * glm::dvec3(0, 0, 1));
            sum += step * step * sight.behind({0.0, 2.0, 0.0}, direction, step);
        }
    }
    // The aureole around it is there too.
    const glm::dvec3 through =
        SkyIntegrator(sky.air, {.orders = 1}, {}).transmittanceAlong({2.0, 0.5, 0.5, 1.0});
    EXPECT_LT(relativeOff(sum, sky.air.sunIlluminanceLux * through), 0.01);
}

TEST(SkyDaylight, LevelGroundIsLitAsTheIntegralSays) {
    const SkyOverScene sky = skyAt(40.0, {2, false});
    const SkySight sight(sky);
    const SkyDaylight day(sight);
    const SkyIntegrator exact(sky.air, {.orders = 3}, std::vector<SkyRay>{{0.0, 0.5, 0.6, 0.3}});
    const double muS = sky.towardsSun.y;
    const glm::dvec3 lux = sky.air.sunIlluminanceLux;
    EXPECT_LT(relativeOff(day.sunLux() * muS, exact.irradiance(0, muS) * lux), 1e-4);
    const glm::dvec3 up = day.irradiance({0.0, 1.0, 0.0});
    EXPECT_GT(up.z, lux.z * exact.irradiance(1, muS).z);
    EXPECT_LT(up.z, 1.5 * lux.z * exact.irradiance(1, muS).z);
    // The ground's light is seen from above it by what looks down.
    EXPECT_GT(day.irradiance({0.0, -1.0, 0.0}).y, 0.05 * (up.y + day.sunLux().y * muS) * 0.9);
    EXPECT_LT(day.irradiance({0.0, -1.0, 0.0}).y, 0.2 * (up.y + day.sunLux().y * muS));
}

TEST(SkyDaylight, ASettingSunIsHalfThere) {
    const SkySight sight(skyAt(0.0, {1, false}));
    const SkySight higher(skyAt(0.5, {1, false}));
    const SkySight lower(skyAt(-0.3, {1, false}));
    const double half = SkyDaylight(sight).sunLux().x;
    EXPECT_GT(half, 0.2 * SkyDaylight(higher).sunLux().x);
    EXPECT_LT(half, 0.6 * SkyDaylight(higher).sunLux().x);
    EXPECT_EQ(SkyDaylight(lower).sunLux().x, 0.0);
}

TEST(SkyDaylight, AShadowsEdgeIsAsWideAsTheSun) {
    // A roof's edge at x = 0, 100 m above a floor, under a sun at the zenith.
    Scene scene;
    test::addShape(scene, test::makeQuad({0, 0, 0}, {40, 0, 0}, {0, 0, -40}),
                   test::makeMaterial(glm::vec3(0.5F)));
    test::addShape(scene, test::makeQuad({-20, 100, 0}, {20, 0, 0}, {0, 0, -40}),
                   test::makeMaterial(glm::vec3(0.5F)));
    scene.materials.back().doubleSided = true;
    ReferenceSettings settings;
    settings.camera = test::makeCamera({0.0, 3.0, 0.0}, {0.0, 0.0, 0.0});
    settings.width = 81;
    settings.height = 81;
    settings.haze.scatteringPerMetre = 0.0;
    settings.ambientLux = 0.0;
    settings.sky = skyAt(90.0, {1, false});
    const ReferencePicture picture = drawReference(scene, settings);
    const double half = viewHalfExtent(settings.camera, 81, 81).x;
    const auto at = [&](int x) { return picture.surfaces[40 * 81 + std::size_t(x)].y; };
    const double right = settings.camera.frame.right().x;
    ASSERT_NEAR(std::abs(right), 1.0, 1e-9);
    const double dark = at(right > 0.0 ? 0 : 80);
    const double lit = at(right > 0.0 ? 80 : 0);
    ASSERT_GT(lit, 5.0 * dark);
    int between = 0;
    for (int x = 0; x < 81; ++x) {
        const double place = right * 3.0 * half * ((2.0 * x + 1.0) / 81.0 - 1.0);
        const double part = std::clamp(place / (100.0 * 0.004653), -1.0, 1.0);
        const double open =
            0.5 + (part * std::sqrt(1.0 - part * part) + std::asin(part)) / std::numbers::pi;
        // The floor reflects a little less towards the sides.
        EXPECT_NEAR((at(x) - dark) / (lit - dark), open, 0.05) << place << " m";
        between += open > 0.05 && open < 0.95 ? 1 : 0;
    }
    EXPECT_GE(between, 20);
}

TEST(SkySight, AReferenceOfAnotherSkyIsRefused) {
    const test::TestFolder folder;
    const auto file = folder.path() / "sky.exr";
    ReferenceSettings settings;
    settings.camera = test::makeCamera({0.0, 2.0, 0.0}, {1.0, 2.1, 0.2});
    settings.width = 8;
    settings.height = 8;
    settings.haze.scatteringPerMetre = 0.0;
    settings.sky = skyAt(20.0, {1, false});
    const ReferencePicture picture = drawReference(Scene(), settings);
    EXPECT_GT(picture.surfaces.front().z, 100.0);
    EXPECT_GT(picture.skyError.rms, 0.0);
    const ReferenceView view = describeReference("a.glb", settings);
    writeExr(file, referenceImage(picture, settings, view, {}));
    const ReferenceFile kept = readReference(file, view);
    EXPECT_EQ(kept.facts.skyError.rms, picture.skyError.rms);
    EXPECT_EQ(kept.facts.skyError.largest, picture.skyError.largest);

    const SkyOverScene right = *settings.sky;
    const auto expectRefused = [&](const char* word) {
        test::expectError(ErrorKind::kBadInput, {"sky.exr", word, "orders 1"},
                          [&] { readReference(file, describeReference("a.glb", settings)); });
        settings.sky = right;
    };
    settings.sky->towardsSun = {0.0, 1.0, 0.0};
    expectRefused("another sky");
    settings.sky->altitudeMetres = 1.0;
    expectRefused("another sky");
    settings.sky->orders = {2, false};
    expectRefused("another sky");
    settings.sky->orders = {4, true};
    expectRefused("orders all");
    settings.sky.reset();
    expectRefused("none");
    settings.sky->air = withoutMie(Atmosphere());
    test::expectError(ErrorKind::kBadInput, {"another sky_air"},
                      [&] { readReference(file, describeReference("a.glb", settings)); });
}

}  // namespace
}  // namespace ribalta
