// What a frame does for its sky: nothing without one, and nothing again that is there already.
#include "render/plan_sky.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "render/frame_plan.h"
#include "sky/sky_ray.h"
#include "support/stage.h"

namespace ribalta::test {
namespace {

struct Outdoors {
    Scene scene;
    Camera camera = makeCamera({0, 2, 8}, {0, 1, 0});
    FrameSettings settings;
    FrameCache cache;

    Outdoors() {
        settings.width = 64;
        settings.height = 48;
        settings.ev100 = 14.0;
        settings.sky.emplace();
        Material glass = makeMaterial(glm::vec3(0.5F));
        glass.alphaMode = Material::AlphaMode::kBlend;  // casts no shadow
        addShape(scene, makeQuad({0, 0, 0}, {5, 0, 0}, {0, 0, -5}), glass);
    }
    /// As one frame after the other.
    std::string nextLine() {
        const FramePlan plan = planFrame(scene, camera, settings, cache);
        keepForNextFrame(scene, plan, cache);
        return plan.describe();
    }
};

TEST(PlanSky, TablesAreMadeOnce) {
    Outdoors stage;
    EXPECT_EQ(stage.nextLine(), "forward sky_tables sky_view aerial sky tonemap");
    EXPECT_EQ(stage.nextLine(), "forward sky tonemap");
    stage.settings.ambientLux = 2.0;
    EXPECT_EQ(stage.nextLine(), "forward sky tonemap") << "the surfaces' light alone";
    stage.settings.width = 65;
    EXPECT_EQ(stage.nextLine(), "forward aerial sky tonemap");
}

TEST(PlanSky, AirBetweenTwoPointsDims) {
    SkyDrawing sky;
    const glm::dvec3 beta = sky.air.rayleighScatteringPerMetre + sky.air.mieExtinctionPerMetre;
    const glm::dvec3 level = transmittanceBetween(sky, {0, 0, 0}, {2e3, 0, 0});
    const glm::dvec3 up = transmittanceBetween(sky, {0, 0, 0}, {0, 2e3, 0});
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(level[c], std::exp(-2e3 * beta[c]), 1e-5);
        const double lengths[] = {8e3 * -std::expm1(-0.25), 1.2e3 * -std::expm1(-2.0 / 1.2)};
        EXPECT_NEAR(up[c],
                    std::exp(-lengths[0] * sky.air.rayleighScatteringPerMetre[c] -
                             lengths[1] * sky.air.mieExtinctionPerMetre[c]),
                    1e-4);
    }
    sky.altitudeMetres = 400e3;
    EXPECT_EQ(transmittanceBetween(sky, {0, 0, 0}, {2e3, 0, 0}), glm::dvec3(1.0));
}

TEST(PlanSky, AMovedSunOrEyeKeepsTheAirsTables) {
    Outdoors stage;
    stage.nextLine();
    stage.settings.sky->towardsSun = glm::normalize(glm::dvec3(1.0, 1.0, 0.0));
    EXPECT_EQ(stage.nextLine(), "forward sky_view aerial sky tonemap");
    stage.settings.sky->towardsSun = glm::normalize(glm::dvec3(0.0, 1.0, -1.0));
    stage.camera = makeCamera({0, 2, 8}, {1, 1, 0});
    EXPECT_EQ(stage.nextLine(), "forward sky_view aerial sky tonemap")
        << "the zenith at the camera is not the scene's";
    stage.camera = makeCamera({0, 2, 8}, {-1, 1, 0});
    EXPECT_EQ(stage.nextLine(), "forward aerial sky tonemap") << "the eye stays where it is";
    stage.camera = makeCamera({0, 3, 8}, {-1, 1, 0});
    EXPECT_EQ(stage.nextLine(), "forward sky_view aerial sky tonemap");
    stage.settings.sky->orders = {1, false};
    EXPECT_EQ(stage.nextLine(), "forward sky_tables sky_view aerial sky tonemap");
}

TEST(PlanSky, ModelsOfTheLiteratureHaveTheirTablesAlone) {
    Outdoors stage;
    stage.settings.sky->model = PrecomputedSkySettings{};
    EXPECT_EQ(stage.nextLine(), "forward sky_tables sky tonemap");
    stage.settings.sky->towardsSun = glm::normalize(glm::dvec3(1.0, 1.0, 0.0));
    stage.settings.sky->orders = {1, false};
    EXPECT_EQ(stage.nextLine(), "forward sky tonemap") << "tables of all suns; orders of its own";
    stage.settings.sky->model = simplifiedSky();
    EXPECT_EQ(stage.nextLine(), "forward sky_tables sky tonemap");
    stage.settings.sky->air = withoutMie(Atmosphere());
    EXPECT_EQ(stage.nextLine(), "forward sky_tables sky tonemap");
    stage.settings.sky->model = ChapmanSky{};
    EXPECT_EQ(stage.nextLine(), "forward sky tonemap");
    stage.settings.sky->model = OwnSky{};
    EXPECT_EQ(stage.nextLine(), "forward sky_tables sky_view aerial sky tonemap");
}

TEST(PlanSky, NothingInViewNeedsNoAirBeforeIt) {
    Outdoors stage;
    stage.camera = makeCamera({0, 2, 8}, {0, 9, 20});
    EXPECT_EQ(stage.nextLine(), "sky_tables sky_view sky tonemap");
}

TEST(PlanSky, WithoutASkyThereIsNone) {
    Outdoors stage;
    stage.settings.sky.reset();
    EXPECT_EQ(stage.nextLine(), "forward tonemap");
    EXPECT_FALSE(stage.cache.sky.air.has_value());
}

TEST(PlanSky, TheSunTakesItsLampsPlace) {
    Outdoors stage;
    stage.scene.directionalLights.resize(2);
    stage.settings.sky->sunLamp = 0;
    const FramePlan plan = planFrame(stage.scene, stage.camera, stage.settings, stage.cache);
    EXPECT_EQ(plan.directionalLights, std::vector<int>{1});
}

TEST(PlanSky, ThePlanetCurvesAway) {
    SkyDrawing sky;
    sky.towardsSun = {1.0, 0.0, 0.0};
    EXPECT_DOUBLE_EQ(skyEye(sky, {0, 1.5, 0}).heightMetres, 1.5);
    EXPECT_NEAR(skyEye(sky, {10e3, 0.0, 0.0}).heightMetres, 1e8 / (2.0 * 6.36e6), 1e-4);
    EXPECT_NEAR(skyEye(sky, {10e3, 0.0, 0.0}).muS, 10e3 / 6.36e6, 1e-8);
    sky.altitudeMetres = 400e3;
    EXPECT_NEAR(skyEye(sky, {0, 1e-3, 0}).heightMetres, 400e3 + 1e-3, 1e-8);
}

// By the shadow's own geometry: rays in all directions, cut where it begins.
TEST(PlanSky, TheShadowIsInViewOnlyWhereARayMayEnterIt) {
    int seen = 0;
    int entered = 0;
    for (const double height : {0.0, 2.0, 5e3, 59e3, 60e3}) {
        for (int step = -40; step <= 60; ++step) {
            SkyDrawing sky;
            const double elevation = 0.005 * step;
            sky.towardsSun = {std::cos(elevation), std::sin(elevation), 0.0};
            sky.altitudeMetres = height;
            const SkyEye eye = skyEye(sky, {});
            bool enters = false;
            for (int i = 0; i <= 400 && !enters; ++i) {
                for (const double cosAzimuth : {-1.0, -0.9, 0.0, 0.9, 1.0}) {
                    const double mu = 2.0 * std::pow(i / 400.0, 3.0) - 1.0 + 1e-9;
                    const AirPath path =
                        airPathTowards(sky.air, eye.heightMetres, mu, eye.muS, cosAzimuth);
                    for (const PathPiece& piece : piecesOf(sky.air, path)) {
                        // Below a metre edges are lost in rounding.
                        enters = enters || (!piece.lit && piece.last - piece.first > 1.0);
                    }
                }
            }
            seen += seesPlanetShadow(sky.air, eye) ? 1 : 0;
            entered += enters ? 1 : 0;
            EXPECT_TRUE(!enters || seesPlanetShadow(sky.air, eye)) << height << ", " << elevation;
        }
    }
    EXPECT_GT(entered, 200);
    EXPECT_LT(seen, 1.2 * entered);
    EXPECT_LT(seen, 450);
}

TEST(PlanSky, BelowTheGroundItLooksFromTheGround) {
    const SkyEye eye = skyEye(SkyDrawing(), {0.0, -3.0, 0.0});
    EXPECT_EQ(eye.heightMetres, 0.0);
    EXPECT_NEAR(eye.belowMetres, 3.0, 1e-9);
}

}  // namespace
}  // namespace ribalta::test
