// The heart: the GPU's `clipped` beams against the double-precision integral of the same formulas,
// and both against Sun et al.'s closed form.
#include <cmath>

#include <gtest/gtest.h>

#include "base/angles.h"
#include "image/read_image.h"
#include "optics/shader_lib.h"
#include "reference/closed_forms.h"
#include "reference_beams.h"
#include "support/stage.h"

namespace ribalta::test {
namespace {

constexpr int kSheets = 64;
// What the project promises of 64 sheets. Measured: at most 0.0014, where the camera looks along
// the axis from behind the lamp, and 0.0003 elsewhere.
constexpr double kPromised = 0.01;

struct View {
    const char* name;
    Camera camera;
};

/// One lamp 6 m above the floor that shines straight down, and the four views of it.
SpotLight downLamp() {
    SpotLight lamp = makeSpot({0.0, 6.0, 0.0}, {0.0, 0.0, 0.0}, 18.0 * kDegree, 20000.0);
    lamp.innerConeAngle = 12.0 * kDegree;
    lamp.color = {1.0F, 0.75F, 0.4F};
    return lamp;
}

std::vector<View> views() {
    return {{"side", makeCamera({0.5, 3.0, 9.0}, {0.0, 3.0, 0.0})},
            {"in the beam", makeCamera({0.3, 2.0, 0.4}, {1.0, 3.2, -1.0}, 1.2)},
            {"facing the lamp", makeCamera({0.2, 0.5, 0.9}, {0.0, 6.0, 0.0}, 0.6)},
            {"along the axis", makeCamera({0.0, 7.0, 0.0}, {0.0, 0.0, 0.0})},
            {"against the axis", makeCamera({0.0, 0.5, 0.0}, {0.0, 6.0, 0.0})}};
}

FrameSettings hazySettings(PhaseFunction::Kind kind = PhaseFunction::Kind::kGibbons, double g = 0.0,
                           double absorption = 0.0) {
    FrameSettings settings = measuringSettings();
    settings.haze.scatteringPerMetre = 0.04;
    settings.haze.absorptionPerMetre = absorption;
    settings.haze.phase.kind = kind;
    settings.haze.phase.g = g;
    settings.beams.method = BeamMethod::kClipped;
    settings.beams.planes = kSheets;
    return settings;
}

void addFloor(Scene& scene) {
    addShape(scene, makeQuad({0, 0, 0}, {300, 0, 0}, {0, 0, -300}), makeMaterial(glm::vec3(0.5F)));
}

/// Draws all views of a scene that a floor at y = 0 may close, against the reference.
void expectViewsAgree(const Scene& scene, const FrameSettings& settings, double bound) {
    const bool open = scene.nodes.empty();
    for (const View& view : views()) {
        const Picture expected =
            referenceBeams(scene, view.camera, settings, open ? openEnd : floorEnd);
        const Picture drawn = drawnBeams(scene, view.camera, settings);
        EXPECT_LT(relativeRmse(drawn, expected), bound) << view.name;
    }
}

class BeamReference : public GpuTest {};

TEST_F(BeamReference, EveryPhaseFunctionOnOpenBeams) {
    using Kind = PhaseFunction::Kind;
    const struct {
        const char* name;
        Kind kind;
        double g;
    } phases[] = {{"gibbons", Kind::kGibbons, 0.0},
                  {"isotropic", Kind::kIsotropic, 0.0},
                  {"hg:0.7", Kind::kHenyeyGreenstein, 0.7},
                  {"cornette-shanks:0.8", Kind::kCornetteShanks, 0.8},
                  {"rayleigh", Kind::kRayleigh, 0.0}};
    Scene scene;
    scene.spotLights.push_back(downLamp());
    for (const auto& phase : phases) {
        SCOPED_TRACE(phase.name);
        expectViewsAgree(scene, hazySettings(phase.kind, phase.g), kPromised);
    }
}

TEST_F(BeamReference, BeamsThatTheFloorEnds) {
    Scene scene;
    scene.spotLights.push_back(downLamp());
    addFloor(scene);
    expectViewsAgree(scene, hazySettings(), kPromised);
}

TEST_F(BeamReference, AFarPlaneEndsBeamsToo) {
    Scene scene;
    scene.spotLights.push_back(downLamp());
    const FrameSettings settings = hazySettings();
    for (const bool floor : {false, true}) {
        if (floor) {
            addFloor(scene);
        }
        for (View view : views()) {
            // Through the middle of the beam from the side, and before the floor from above.
            view.camera.farMetres = view.name == std::string("side") ? 9.05 : 6.5;
            const Picture expected =
                referenceBeams(scene, view.camera, settings, floor ? floorEnd : openEnd);
            EXPECT_LT(relativeRmse(drawnBeams(scene, view.camera, settings), expected), kPromised)
                << view.name << ", floor " << floor;
        }
    }
}

TEST_F(BeamReference, AbsorptionAndRange) {
    Scene scene;
    scene.spotLights.push_back(downLamp());
    scene.spotLights[0].rangeMetres = 5.0;
    expectViewsAgree(scene, hazySettings(PhaseFunction::Kind::kGibbons, 0.0, 0.15), kPromised);
}

TEST_F(BeamReference, APyramidAndSeveralLampsAtOnce) {
    Scene scene;
    scene.spotLights.push_back(downLamp());
    scene.spotLights[0].beamShape = BeamShape::kPyramid;
    scene.spotLights.push_back(makeSpot({3, 4, 1}, {-1, 0, 0}, 10.0 * kDegree, 8000.0));
    scene.spotLights.push_back(makeSpot({-3, 1, -1}, {0, 5, 0}, 4.0 * kDegree, 30000.0));
    scene.spotLights[2].color = {0.1F, 0.3F, 1.0F};
    addFloor(scene);
    expectViewsAgree(scene, hazySettings(), kPromised);
}

TEST_F(BeamReference, AnOrthographicCamera) {
    Scene scene;
    scene.spotLights.push_back(downLamp());
    addFloor(scene);
    Camera camera;
    camera.frame = lookAt({5.0, 5.0, 5.0}, {0.0, 3.0, 0.0});
    camera.lens = OrthographicLens{4.0, 3.0};
    camera.farMetres = 60.0;
    const FrameSettings settings = hazySettings();
    const Picture expected = referenceBeams(scene, camera, settings, floorEnd);
    EXPECT_LT(relativeRmse(drawnBeams(scene, camera, settings), expected), kPromised);
}

/// A picture shrunk to side x side texels, each the mean of those it stands for. (Of encoded
/// values: any picture will do.)
Image shrunk(const FloatImage& picture, int side) {
    const int step = picture.width / side;
    return makeImage(side, side, [&](int x, int y) {
        glm::vec4 sum(0.0F);
        for (int i = 0; i < step * step; ++i) {
            for (int c = 0; c < 3; ++c) {
                const int channel = picture.channels.size() >= 3 ? c : 0;
                sum[c] += picture.at(step * x + i % step, step * y + i / step, channel) /
                          float(step * step);
            }
        }
        return glm::vec4(glm::vec3(sum), 1.0F);
    });
}

TEST_F(BeamReference, ALightMapInTheHaze) {
    // So coarse that no step between sheets covers a texel: what is left is the pixel's own width,
    // over which the reference filters too.
    const FloatImage star = readFloatImage(RIBALTA_SOURCE_DIR "/samples/scenes/gobo_star.png");
    ASSERT_EQ(star.width, 512);
    ASSERT_EQ(star.height, 512);
    Scene scene;
    scene.spotLights.push_back(downLamp());
    useLightMap(scene, scene.spotLights[0], shrunk(star, 32), 0.4);
    addFloor(scene);
    FrameSettings settings = hazySettings();
    settings.width = 40;
    settings.height = 30;
    for (View view : views()) {
        if (view.name == std::string("side")) {
            view.camera.lens = PerspectiveLens{0.15, std::nullopt};
        }
        const Picture expected =
            referenceBeams(scene, view.camera, settings, floorEnd, nullptr, 1e-4);
        EXPECT_LT(relativeRmse(drawnBeams(scene, view.camera, settings), expected), kPromised)
            << view.name;
    }
}

/// The closed form over the part of each ray inside an even pyramid.
Picture closedForm(const SpotLight& lamp, const Camera& camera, const FrameSettings& settings) {
    Picture picture{settings.width, settings.height, {}};
    const glm::dmat3 toLamp =
        glm::transpose(glm::dmat3(lamp.frame.right(), lamp.frame.up(), lamp.frame.forward()));
    for (int y = 0; y < settings.height; ++y) {
        for (int x = 0; x < settings.width; ++x) {
            const PixelRay ray = pixelRay(camera, settings.width, settings.height, x, y);
            const glm::dvec3 origin = toLamp * (ray.origin - lamp.frame.position);
            const glm::dvec3 direction = toLamp * ray.direction;
            double entry = 0.0;
            double exit = 0.0;
            double value = 0.0;
            if (shader::clipToPyramid(origin, direction, std::tan(lamp.outerConeAngle),
                                      shader::kLensMetres, 1e30,
                                      camera.nearMetres * ray.metresPerDepth, 1e9, entry, exit)) {
                const double h = glm::length(glm::cross(origin, direction));
                const double nearest = -glm::dot(origin, direction);
                value = lamp.intensityCandela *
                        isotropicPointSource(h, nearest, entry - nearest, exit - nearest,
                                             settings.haze.scatteringPerMetre,
                                             settings.haze.extinctionPerMetre());
            }
            picture.pixels.push_back(value * glm::dvec3(lamp.color));
        }
    }
    return picture;
}

TEST_F(BeamReference, BothAgreeWithSunsClosedForm) {
    Scene scene;
    scene.spotLights.push_back(downLamp());
    scene.spotLights[0].beamShape = BeamShape::kPyramid;
    for (const double absorption : {0.0, 0.2}) {
        const FrameSettings settings =
            hazySettings(PhaseFunction::Kind::kIsotropic, 0.0, absorption);
        for (const View& view : views()) {
            SCOPED_TRACE(view.name);
            // The rays of the axis itself have h = 0, which the closed form does not know.
            Camera camera = view.camera;
            camera.frame.position += glm::dvec3(0.013, 0.0, 0.017);
            const Picture exact = closedForm(scene.spotLights[0], camera, settings);
            const Picture reference = referenceBeams(scene, camera, settings, openEnd);
            EXPECT_LT(relativeRmse(reference, exact), 1e-4);
            EXPECT_LT(relativeRmse(drawnBeams(scene, camera, settings), exact), 0.005);
        }
    }
}

TEST_F(BeamReference, FewerSheetsAreWorseAndMoreAreBetter) {
    Scene scene;
    scene.spotLights.push_back(downLamp());
    FrameSettings settings = hazySettings();
    const Camera camera = views()[1].camera;
    const Picture expected = referenceBeams(scene, camera, settings, openEnd);
    double before = 1.0;
    for (const int sheets : {4, 8, 16, 32}) {
        settings.beams.planes = sheets;
        const double error = relativeRmse(drawnBeams(scene, camera, settings), expected);
        EXPECT_LT(error, 0.5 * before) << sheets;
        before = error;
    }
}

// Interpolation may be off by the tolerance at one pixel, by what the cells' own estimate misses at
// some, and not in the mean.
TEST_F(BeamReference, AdaptiveIsWithinItsToleranceOnTheScreen) {
    Scene scene;
    scene.spotLights.push_back(downLamp());
    useLightMap(scene, scene.spotLights[0],
                shrunk(readFloatImage(RIBALTA_SOURCE_DIR "/samples/scenes/gobo_star.png"), 64),
                0.4);
    addFloor(scene);
    FrameSettings settings = hazySettings();
    settings.width = 161;  // not a multiple of anything
    settings.height = 119;
    settings.ev100 = 6.0;
    const auto shown = [](const glm::dvec3& luminance) {
        return shader::srgbEncode(
            shader::toneNeutral(luminance * double(shader::exposureFromEv100(6.0))));
    };
    for (const View& view : views()) {
        settings.beams.method = BeamMethod::kClipped;
        const Picture everyPixel = drawnBeams(scene, view.camera, settings);
        settings.beams.method = BeamMethod::kAdaptive;
        for (const double tolerance : {0.0, 0.01, 0.05}) {
            settings.beams.tolerance = tolerance;
            const Picture drawn = drawnBeams(scene, view.camera, settings);
            double sum = 0.0;
            for (std::size_t i = 0; i < drawn.pixels.size(); ++i) {
                const glm::dvec3 off = shown(drawn.pixels[i]) - shown(everyPixel.pixels[i]);
                sum += glm::dot(off, off) / 3.0;
            }
            EXPECT_LE(std::sqrt(sum / double(drawn.pixels.size())), 0.3 * tolerance + 1e-4)
                << view.name << ", tolerance " << tolerance;
        }
    }
}

// A ball in the middle of the beam, by its equation. A hard edge falls between two sheets, so each
// ray is off by up to half of one of them, and then by the shadow map's texels (256 across here):
// measured 0.020 of 64 sheets and 0.010 of 512.
TEST_F(BeamReference, AShadowInTheHaze) {
    const glm::dvec3 centre(0.2, 3.0, 0.1);
    const double radius = 0.4;
    Scene scene;
    scene.spotLights.push_back(downLamp());
    addShape(scene, makeSphere(centre, float(radius), 400), makeMaterial(glm::vec3(0.5F)));
    const auto crossing = [&](const glm::dvec3& origin, const glm::dvec3& direction) {
        const glm::dvec3 to = centre - origin;
        const double along = glm::dot(to, direction);
        const double square = radius * radius - glm::dot(to, to) + along * along;
        const double t = along - std::sqrt(std::max(square, 0.0));
        return square > 0.0 && t > 0.0 ? t : std::numeric_limits<double>::infinity();
    };
    const LampVisibility isVisible = [&](const SpotLight& lamp, const glm::dvec3& point) {
        const glm::dvec3 to = point - lamp.frame.position;
        const double length = glm::length(to);
        return crossing(lamp.frame.position, to / length) >= length;
    };
    FrameSettings settings = hazySettings();
    for (const View& view : views()) {
        const Picture expected = referenceBeams(scene, view.camera, settings, crossing, isVisible);
        settings.beams.planes = kSheets;
        EXPECT_LT(relativeRmse(drawnBeams(scene, view.camera, settings), expected), 0.03)
            << view.name;
        settings.beams.planes = 8 * kSheets;
        EXPECT_LT(relativeRmse(drawnBeams(scene, view.camera, settings), expected), 0.015)
            << view.name;
    }
}

}  // namespace
}  // namespace ribalta::test
