// Whole reference pictures: surfaces by hand, light maps filtered over a pixel, files that are
// refused.
#include "reference/reference_picture.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "image/write_image.h"
#include "optics/shader_lib.h"
#include "reference/integrate_beams.h"
#include "reference/light_map_pyramid.h"
#include "reference/reference_file.h"
#include "support/expect_error.h"
#include "support/stage.h"
#include "support/test_folder.h"

namespace ribalta {
namespace {

ReferenceSettings lookingDown() {
    ReferenceSettings settings;
    settings.camera = test::makeCamera({0.0, 3.0, 0.0}, {0.0, 0.0, 0.0});
    settings.width = 9;
    settings.height = 7;
    settings.haze.scatteringPerMetre = 0.0;
    settings.haze.absorptionPerMetre = 0.2;
    settings.ambientLux = 0.0;
    return settings;
}

Scene floorScene(const Material& material) {
    Scene scene;
    test::addShape(scene, test::makeQuad({0, 0, 0}, {10, 0, 0}, {0, 0, -10}), material);
    return scene;
}

TEST(ReferencePicture, AFloorUnderTheSun) {
    Material dull = test::makeMaterial(glm::vec3(0.0F));
    dull.emission = {3.0F, 2.0F, 1.0F};
    Scene scene = floorScene(dull);
    const ReferenceSettings settings = lookingDown();
    const ReferencePicture dark = drawReference(scene, settings);
    const std::size_t middle = 3 * 9 + 4;
    EXPECT_NEAR(dark.depths[middle], 3.0, 1e-12);
    EXPECT_NEAR(dark.surfaces[middle].x, 3.0 * std::exp(-0.2 * 3.0), 1e-12);
    EXPECT_NEAR(dark.surfaces[middle].z, 1.0 * std::exp(-0.2 * 3.0), 1e-12);
    EXPECT_EQ(dark.beams[middle], glm::dvec3(0.0));
    // Farther along the ray towards the corners, and as deep.
    EXPECT_NEAR(dark.depths[0], 3.0, 1e-12);
    EXPECT_LT(dark.surfaces[0].x, dark.surfaces[middle].x);

    DirectionalLight sun;
    sun.direction = {0.0, -1.0, 0.0};
    sun.illuminanceLux = 100.0;
    scene.directionalLights.push_back(sun);
    const ReferencePicture lit = drawReference(scene, settings);
    // Black, but for its highlight.
    const glm::dvec3 expected =
        100.0 * std::exp(-0.6) *
        shader::metallicRoughnessBrdf(glm::dvec3(0.0), 0.0, 1.0, 1.0, 1.0, 1.0, 1.0);
    EXPECT_NEAR(lit.surfaces[middle].x - dark.surfaces[middle].x, expected.x, 1e-12);
}

// Even light of luminance L gives pi L lux, of which a rough surface sends back its albedo times L.
TEST(ReferencePicture, AnEnvironmentLightsTheFloor) {
    Scene scene = floorScene(test::makeMaterial(glm::vec3(0.5F)));
    IrradianceCoefficients even{};
    const double luminance = 70.0;
    even[0] = glm::dvec3(std::numbers::pi * luminance * std::sqrt(4.0 * std::numbers::pi));
    scene.environment.emplace();
    scene.environment->lux = irradianceForm(even, glm::dmat3(1.0));
    ReferenceSettings settings = lookingDown();
    settings.haze.absorptionPerMetre = 0.0;
    const std::size_t middle = 3 * 9 + 4;
    EXPECT_NEAR(drawReference(scene, settings).surfaces[middle].x, 0.54 * luminance, 1e-9);
    // Beside the settings' even light, and from above: y's coefficient.
    settings.ambientLux = 10.0;
    even[1] = {0.0, 100.0, 0.0};
    scene.environment->lux = irradianceForm(even, glm::dmat3(1.0));
    const double fromAbove = 100.0 * std::sqrt(3.0 / (4.0 * std::numbers::pi));
    const glm::dvec3 both = drawReference(scene, settings).surfaces[middle];
    EXPECT_NEAR(both.x, 0.54 * (luminance + 10.0 / std::numbers::pi), 1e-9);
    EXPECT_NEAR(both.y, both.x + 0.54 * fromAbove / std::numbers::pi, 1e-9);
}

TEST(ReferencePicture, ALampLightsTheFloorButNotBehindABox) {
    Scene scene = floorScene(test::makeMaterial(glm::vec3(0.8F)));
    scene.spotLights.push_back(test::makeSpot({0.0, 2.0, 0.0}, {0.0, 0.0, 0.0}, 0.6, 500.0));
    const ReferenceSettings settings = lookingDown();
    const std::size_t middle = 3 * 9 + 4;
    const ReferencePicture open = drawReference(scene, settings);
    const double brdf =
        shader::metallicRoughnessBrdf(glm::dvec3(double(0.8F)), 0.0, 1.0, 1.0, 1.0, 1.0, 1.0).x;
    EXPECT_NEAR(open.surfaces[middle].x, brdf * 500.0 / 4.0 * std::exp(-0.2 * 5.0),
                1e-9 * open.surfaces[middle].x);
    // Hidden from the lamp, but not from the eye, by what stands beside their line: the two are one
    // above the other, so the box is seen instead.
    test::addShape(scene, test::makeBox({-0.2F, 0.5F, -0.2F}, {0.2F, 0.6F, 0.2F}),
                   test::makeMaterial(glm::vec3(0.8F)));
    scene.spotLights[0].frame = lookAt({1.5, 2.0, 0.0}, {0.0, 0.0, 0.0});
    const ReferencePicture shaded = drawReference(scene, settings);
    EXPECT_NEAR(shaded.depths[middle], 2.4, 1e-6);
    // To the left of the box lies its shadow: from (1.5, 2) past (0.2, 0.5) or (-0.2, 0.6).
    const std::size_t left = 3 * 9 + 3;
    EXPECT_EQ(shaded.surfaces[left], glm::dvec3(0.0));
    EXPECT_GT(shaded.surfaces[3 * 9 + 6].x, 0.0);
}

TEST(LightMapPyramid, KeepsTheMeanAndBlendsLevels) {
    const Image image = test::makeImage(
        5, 3, [](int x, int y) { return glm::vec4(0.2F * float(x), 0.3F * float(y), 0.5F, 1.0F); });
    const LightMapPyramid pyramid(image);
    ASSERT_EQ(pyramid.lastLevel(), 2);
    glm::dvec3 mean(0.0);
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 5; ++x) {
            mean += pyramid.at({(x + 0.5) / 5.0, (y + 0.5) / 3.0}, 0.0) / 15.0;
        }
    }
    const glm::dvec3 last = pyramid.at({0.1, 0.9}, 7.0);
    const glm::dvec3 before = pyramid.at({0.1, 0.9}, 1.0);
    const glm::dvec3 between = pyramid.at({0.1, 0.9}, 1.25);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(last[c], mean[c], 1e-6);
        EXPECT_NEAR(between[c], 0.75 * before[c] + 0.25 * last[c], 1e-12);
    }
}

TEST(IntegrateBeams, FiltersALightMapOverTheWidthOfThePixel) {
    const Image image = test::makeImage(64, 64, [](int x, int y) {
        return glm::vec4(float((x * 37 + y * 11) % 64) / 63.0F, float((x / 3 + y) % 2), 0.3F, 1.0F);
    });
    const LightMapPyramid pyramid(image);
    SpotLight lamp = test::makeSpot({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0.5, 1000.0);
    lamp.innerConeAngle = 0.4;
    lamp.lightMap = LightMap{0, 0.2};
    Haze haze;
    haze.scatteringPerMetre = 0.1;
    haze.phase.kind = PhaseFunction::Kind::kIsotropic;
    const BeamIntegrator integrator({&lamp, 1}, {&image, 1}, haze, nullptr, 1e-7);
    const glm::dvec3 direction = glm::normalize(glm::dvec3(-0.9, 0.3, -0.15));
    const BeamRay ray{{3.0, -0.5, 0.3}, direction, 0.0, 6.0, 0.002, 0.03};
    const BeamLamp beam(lamp, 0, &pyramid);
    const double texels = 0.5 * 64.0 / std::tan(0.5);
    constexpr int kSteps = 400000;
    glm::dvec3 sum(0.0);
    for (int i = 0; i < kSteps; ++i) {
        const double t = 6.0 * (i + 0.5) / kSteps;
        const glm::dvec3 place = beam.toBeam(ray.origin + t * direction);
        const double r = glm::length(place);
        if (place.z < 0.05 || place.z / r < std::cos(0.5)) {
            continue;
        }
        const double level = std::log2(texels * (ray.width + ray.widening * t) / place.z);
        const double ramp = (place.z / r - std::cos(0.5)) / (std::cos(0.4) - std::cos(0.5));
        sum += 1000.0 * pyramid.at(beam.lightMapUv(glm::dvec2(place) / place.z), level) *
               (std::min(ramp, 1.0) * std::min(ramp, 1.0) * 0.1 / (4.0 * std::numbers::pi) *
                std::exp(-0.1 * (t + r)) / (r * r) * 6.0 / kSteps);
    }
    const BeamLight light = integrator.along(ray);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(light.value[c], sum[c], 1e-5 * sum[c]);
    }
    EXPECT_LT(light.error, 1e-6 * light.value.x);
}

TEST(ReferenceFile, IsReadBackAndRefusedForAnotherView) {
    const test::TestFolder folder;
    Material glowing = test::makeMaterial(glm::vec3(0.0F));
    glowing.emission = {3.0F, 2.0F, 1.0F};
    const Scene scene = floorScene(glowing);
    ReferenceSettings settings = lookingDown();
    const ReferenceView view = describeReference("floor.glb", settings);
    ReferencePicture picture = drawReference(scene, settings);
    picture.largestError = 1.0 / 3.0;  // to its last digit
    picture.rmsError = 1e-300;
    const std::filesystem::path file = folder.path() / "a.exr";
    writeExr(file, referenceImage(picture, settings, view, {true, true}));

    const auto [image, facts] = readReference(file, view);
    EXPECT_EQ(facts.view.size, "9x7");
    EXPECT_EQ(facts.largestError, picture.largestError);
    EXPECT_EQ(facts.rmsError, picture.rmsError);
    EXPECT_NEAR(image.at(4, 3, image.channel("G")), 2.0 * std::exp(-0.6), 1e-6);
    EXPECT_NEAR(image.at(4, 3, image.channel("Z")), 3.0, 1e-6);
    EXPECT_NEAR(image.at(4, 3, image.channel("transmittance.B")), std::exp(-0.6), 1e-6);
    EXPECT_EQ(image.at(4, 3, image.channel("beams.R")), 0.0F);

    const auto refused = [&](const std::string& word) {
        test::expectError(ErrorKind::kBadInput, {"a.exr", word},
                          [&] { readReference(file, describeReference("floor.glb", settings)); });
    };
    settings.width = 10;
    refused("another size (9x7; expected 10x7)");
    settings.width = 9;
    settings.camera.frame.position.x = 0.1;
    refused("another camera");
    settings.camera.frame.position.x = 0.0;
    settings.haze.phase.k *= 2.0;
    refused("another haze");
    test::expectError(ErrorKind::kBadInput, {"another scene"},
                      [&] { readReference(file, describeReference("b.glb", lookingDown())); });

    FloatImage plain;
    plain.width = 1;
    plain.height = 1;
    plain.channels = {"R", "G", "B"};
    plain.values = {1.0F, 1.0F, 1.0F};
    writeExr(folder.path() / "plain.exr", plain);
    test::expectError(ErrorKind::kBadInput, {"plain.exr", "is no reference"},
                      [&] { readReference(folder.path() / "plain.exr", view); });
    // Numbers as text are not what a reference is written with.
    plain = image;
    plain.facts["rms_error"] = "1e-300";
    writeExr(folder.path() / "text.exr", plain);
    test::expectError(ErrorKind::kBadInput, {"text.exr", "is no reference"},
                      [&] { readReference(folder.path() / "text.exr", view); });
}

}  // namespace
}  // namespace ribalta
