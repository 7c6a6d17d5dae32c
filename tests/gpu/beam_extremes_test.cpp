// Beams where single precision and special directions would show: narrow and far, far from the
// origin, a camera at the lamp or on its axis, no end to the view.
#include <cmath>

#include "base/angles.h"
#include "reference_beams.h"
#include "support/stage.h"

namespace ribalta::test {
namespace {

FrameSettings thinHazeSettings(int width = 48, int height = 36) {
    FrameSettings settings = measuringSettings(width, height);
    settings.haze.scatteringPerMetre = 0.03;
    settings.haze.absorptionPerMetre = 0.01;
    settings.beams.planes = 64;
    return settings;
}

class BeamExtremes : public GpuTest {};

TEST_F(BeamExtremes, ANarrowBeamFiftyMetresAway) {
    Scene scene;
    scene.spotLights.push_back(makeSpot({0, 4, 0}, {0, -4, 0}, 0.5 * kDegree, 1e6));
    const FrameSettings settings = thinHazeSettings();
    // From 50 m the beam is 4 cm wide at the target and eight pixels of the picture.
    const Camera camera = makeCamera({30.0, 2.0, 40.0}, {0.0, 2.0, 0.0}, 0.003);
    const Picture exact = referenceBeams(scene, camera, settings, openEnd);
    // The falloff of so narrow a cone lives in the last four digits of its cosines: 6e-8 of 3.8e-5
    // for each of three roundings, squared.
    EXPECT_LT(relativeRmse(drawnBeams(scene, camera, settings), exact), 0.01);

    // The same as a pyramid, without a falloff: only the beam's ends count.
    scene.spotLights[0].beamShape = BeamShape::kPyramid;
    const Picture exactPyramid = referenceBeams(scene, camera, settings, openEnd);
    EXPECT_LT(relativeRmse(drawnBeams(scene, camera, settings), exactPyramid), 0.01);
}

TEST_F(BeamExtremes, ABeamHalfAKilometreAway) {
    Scene scene;
    scene.spotLights.push_back(makeSpot({0, 10, 0}, {20, 0, 0}, 10.0 * kDegree, 1e6));
    FrameSettings settings = thinHazeSettings();
    settings.haze.scatteringPerMetre = 0.002;
    settings.haze.absorptionPerMetre = 0.0;
    const Camera camera = makeCamera({0.0, 5.0, 500.0}, {5.0, 5.0, 0.0}, 0.04);
    const Picture exact = referenceBeams(scene, camera, settings, openEnd);
    EXPECT_LT(relativeRmse(drawnBeams(scene, camera, settings), exact), 0.01);
}

/// A small stage with a shadow, a light map and three kinds of lamps around `origin`.
Frame3 drawAt(const glm::dvec3& origin) {
    Scene scene;
    const glm::dmat4 place(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 1, 0, 0), glm::dvec4(0, 0, 1, 0),
                           glm::dvec4(origin, 1.0));
    addShape(scene, makeQuad({0, 0, 0}, {5, 0, 0}, {0, 0, -5}), makeMaterial(glm::vec3(0.5F)),
             place);
    addShape(scene, makeSphere({0, 1, 0}, 0.5F), makeMaterial({0.8F, 0.2F, 0.1F}), place);
    SpotLight lamp = makeSpot(origin + glm::dvec3(1, 5, 1), origin, 0.3, 2000.0);
    useLightMap(scene, lamp, makeImage(16, 16, [](int x, int y) {
                    return glm::vec4((x + y) % 2 == 0 ? 1.0F : 0.3F, 1.0F, float(x) / 15.0F, 1.0F);
                }));
    scene.spotLights.push_back(lamp);
    PointLight point;
    point.position = origin + glm::dvec3(-2, 2, 1);
    point.intensityCandela = 20.0;
    scene.pointLights.push_back(point);
    scene.directionalLights.emplace_back();
    const Camera camera = makeCamera(origin + glm::dvec3(0, 2, 7), origin + glm::dvec3(0, 1.5, 0));
    FrameSettings settings = thinHazeSettings(64, 48);
    settings.ambientLux = 1.0;
    FrameLayers layers;
    layers.beams = layers.depth = layers.normal = layers.transmittance = true;
    return drawOnce(scene, camera, settings, layers);
}

TEST_F(BeamExtremes, TenKilometresFromTheOriginNothingChanges) {
    const Frame3 here = drawAt({0, 0, 0});
    const Frame3 there = drawAt({12345.678, -3210.123, 9876.543});
    ASSERT_EQ(here.image.values.size(), there.image.values.size());
    // Only what is relative to the camera reaches the GPU; doubles hold 10 km to 2e-12 m, where
    // singles would be off by half a millimetre.
    int off = 0;
    for (std::size_t i = 0; i < here.image.values.size(); ++i) {
        const auto a = double(here.image.values[i]);
        const auto b = double(there.image.values[i]);
        off += std::isfinite(a) && std::abs(a - b) > 2e-5 * (std::abs(a) + 1e-2) ? 1 : 0;
        EXPECT_EQ(std::isfinite(a), std::isfinite(b));
    }
    // A sample at a shadow's very edge may fall to the other side.
    EXPECT_LE(off, int(here.image.values.size() / 1000));
}

TEST_F(BeamExtremes, ACameraAtTheLampAgreesWithTheReference) {
    Scene scene;
    scene.spotLights.push_back(makeSpot({0.5, 3, 0}, {0.5, 3, -1}, 25.0 * kDegree, 1000.0));
    const FrameSettings settings = thinHazeSettings();
    const Camera camera = makeCamera({0.5, 3, 0}, {0.5, 3, -1}, 0.7);
    const Picture exact = referenceBeams(scene, camera, settings, openEnd);
    EXPECT_LT(relativeRmse(drawnBeams(scene, camera, settings), exact), 0.01);
}

/// Fails where a pixel is NaN, infinite or negative; says whether any is lit.
bool isFiniteAndLit(const Frame3& frame) {
    EXPECT_EQ(countNotFinite(frame), 0);
    bool lit = false;
    for (int y = 0; y < frame.image.height; ++y) {
        for (int x = 0; x < frame.image.width; ++x) {
            const glm::dvec3 beams = frame.color(x, y, "beams");
            EXPECT_GE(std::min({beams.x, beams.y, beams.z}), 0.0) << x << ", " << y;
            lit = lit || beams.x > 0.0;
        }
    }
    return lit;
}

TEST_F(BeamExtremes, EveryPixelIsFiniteWhereverTheCameraStands) {
    const double angles[] = {0.5 * kDegree, 15.0 * kDegree, 80.0 * kDegree};
    // Odd sides: the middle pixel's ray is the axis itself.
    FrameSettings settings = thinHazeSettings(17, 13);
    settings.beams.planes = 16;
    FrameLayers layers;
    layers.beams = layers.transmittance = true;
    for (const double angle : angles) {
        for (const bool pyramid : {false, true}) {
            for (const bool floor : {false, true}) {
                Scene scene;
                scene.spotLights.push_back(makeSpot({0, 4, 0}, {0, 4, -1}, angle, 1e5));
                scene.spotLights[0].beamShape = pyramid ? BeamShape::kPyramid : BeamShape::kCone;
                if (floor) {
                    addShape(scene, makeQuad({0, 0, 0}, {50, 0, 0}, {0, 0, -50}),
                             makeMaterial(glm::vec3(0.5F)));
                }
                Renderer renderer(scene);
                settings.beamsOutput = true;
                const std::pair<glm::dvec3, glm::dvec3> places[] = {
                    {{0, 4, 0}, {0, 4, -1}},    // at the lamp, along its axis
                    {{0, 4, 0}, {0, 4, 1}},     // at the lamp, away
                    {{0, 4, 3}, {0, 4, 0}},     // behind it, along the axis
                    {{0, 4, -3}, {0, 4, 0}},    // against the axis
                    {{0, 4, -3}, {0, 4, -9}},   // inside, along the axis
                    {{0, 4, -3}, {1, 4, -3}},   // inside, across
                    {{0, 4, 0}, {1, 4, 0}},     // in the lens plane
                    {{5, 4, -3}, {0, 4, -3}}};  // from the side
                for (const auto& [position, target] : places) {
                    for (int lens = 0; lens < 3; ++lens) {
                        Camera camera = makeCamera(position, target);
                        if (lens > 0) {
                            camera.farMetres = 40.0;
                        }
                        if (lens == 2) {
                            camera.lens = OrthographicLens{2.0, 1.5};
                        }
                        renderer.draw(camera, settings);
                        isFiniteAndLit(readBack(renderer, layers));
                        if (testing::Test::HasFailure()) {
                            FAIL() << "half angle " << angle / kDegree << ", pyramid " << pyramid
                                   << ", floor " << floor << ", camera at " << position.x << ", "
                                   << position.y << ", " << position.z << " towards " << target.x
                                   << ", " << target.y << ", " << target.z << ", lens " << lens;
                        }
                    }
                }
            }
        }
    }
}

TEST_F(BeamExtremes, SharpestPhaseFunctionsStayFinite) {
    Scene scene;
    scene.spotLights.push_back(makeSpot({0, 0, 0}, {0, 0, -1}, 0.2, 1e6));
    FrameSettings settings = thinHazeSettings(17, 13);
    FrameLayers layers;
    layers.beams = true;
    const Camera against = makeCamera({0, 0, -5}, {0, 0, 0});
    for (const double g : {-0.9999, -0.9, 0.9, 0.9999}) {
        for (const auto kind :
             {PhaseFunction::Kind::kHenyeyGreenstein, PhaseFunction::Kind::kCornetteShanks}) {
            settings.haze.phase.kind = kind;
            settings.haze.phase.g = g;
            EXPECT_TRUE(isFiniteAndLit(drawOnce(scene, against, settings, layers))) << g;
        }
    }
}

TEST_F(BeamExtremes, ARangeShorterThanTheLensIsDark) {
    Scene scene;
    scene.spotLights.push_back(makeSpot({0, 0, 0}, {0, 0, -1}, 0.5, 1e6));
    scene.spotLights[0].rangeMetres = 0.03;
    FrameLayers layers;
    layers.beams = true;
    Camera camera = makeCamera({0.3, 0, 0}, {0, 0, 0});
    camera.nearMetres = 0.01;
    EXPECT_FALSE(isFiniteAndLit(drawOnce(scene, camera, thinHazeSettings(), layers)));
}

TEST_F(BeamExtremes, ThickHazeAndDarkLampsLeaveNothingBroken) {
    Scene scene;
    scene.spotLights.push_back(makeSpot({0, 0, 0}, {0, 0, -1}, 0.5, 1e6));
    FrameSettings settings = thinHazeSettings();
    settings.haze.scatteringPerMetre = 500.0;
    FrameLayers layers;
    layers.beams = layers.transmittance = true;
    EXPECT_EQ(countNotFinite(drawOnce(scene, makeCamera({5, 0, -3}, {0, 0, -3}), settings, layers)),
              0);
}

}  // namespace
}  // namespace ribalta::test
