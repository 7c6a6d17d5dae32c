// The light that falls on surfaces, in lux: by the lamps' own formula, whatever the surfaces are
// made of; and its false colours.
#include <cmath>

#include "gpu_test.h"
#include "optics/photometry.h"
#include "optics/shader_lib.h"
#include "support/stage.h"

namespace ribalta::test {
namespace {

// Seen straight from above: metres of the floor along x and z at the centre of a pixel.
class Illuminance : public GpuTest {
  protected:
    Illuminance() {
        settings_.illuminance.emplace();
        settings_.haze.scatteringPerMetre = 0.05;  // dims the way from the lamp
        camera_.lens = OrthographicLens{4.0, 3.0};
        camera_.frame = lookAt({0, 10, 0}, {0, 0, 0}, {0, 0, -1});
        camera_.farMetres = 100.0;
    }

    static Scene floorOf(const Material& material) {
        Scene scene;
        addShape(scene, makeQuad({0, 0, 0}, {6, 0, 0}, {0, 0, -6}), material);
        return scene;
    }

    FrameSettings settings_ = measuringSettings();
    Camera camera_;
};

TEST_F(Illuminance, IsThatOfTheLampsWhateverTheMaterial) {
    Material glowing = makeMaterial({0.2F, 0.9F, 0.1F}, 1.0F, 0.3F);
    glowing.emission = glm::vec3(1000.0F);
    Material unlit = makeMaterial({1.0F, 1.0F, 1.0F});
    unlit.unlit = true;
    for (const Material& material : {makeMaterial({0.8F, 0.5F, 0.2F}), glowing, unlit}) {
        Scene scene = floorOf(material);
        scene.spotLights.push_back(makeSpot({0, 5, 0}, {0, 0, 0}, 0.9));
        scene.spotLights[0].innerConeAngle = 0.8;
        scene.spotLights[0].color = {1.0F, 0.5F, 0.25F};
        scene.pointLights.emplace_back();
        scene.pointLights[0].position = {1, 2, 1};
        scene.pointLights[0].intensityCandela = 300.0;
        const Frame3 frame = drawOnce(scene, camera_, settings_);
        for (int y = 0; y < settings_.height; ++y) {
            for (int x = 0; x < settings_.width; ++x) {
                const PixelRay ray = pixelRay(camera_, settings_.width, settings_.height, x, y);
                const auto fall = [&](const glm::dvec3& lamp, double candela) {
                    const double d = glm::distance(lamp, {ray.origin.x, 0.0, ray.origin.z});
                    return candela * lamp.y / (d * d * d) *
                           std::exp(-settings_.haze.extinctionPerMetre() * d);
                };
                const glm::dvec3 expected =
                    fall({0, 5, 0}, 1000.0) * glm::dvec3(1, 0.5, 0.25) + fall({1, 2, 1}, 300.0);
                const glm::dvec3 drawn = frame.color(x, y);
                // Single precision along the way.
                EXPECT_LT(glm::length(drawn - expected), 1e-4 * glm::length(expected))
                    << x << ", " << y;
            }
        }
    }
}

TEST_F(Illuminance, AmbientLightAndShadows) {
    Scene scene = floorOf(makeMaterial({0.3F, 0.3F, 0.3F}));
    addShape(scene, makeBox({-1, 1, -1}, {1, 1.2F, 1}), makeMaterial({1, 1, 1}));
    scene.spotLights.push_back(makeSpot({0, 5, 0}, {0, 0, 0}, 0.9));
    settings_.ambientLux = 7.0;
    // From below the box, where the lamp does not reach: ambient light alone, full from above.
    camera_.frame = lookAt({0, 0.5, 0}, {0, 0, 0}, {0, 0, -1});
    camera_.lens = OrthographicLens{0.4, 0.3};
    const Frame3 frame = drawOnce(scene, camera_, settings_);
    EXPECT_NEAR(luminance(frame.color(settings_.width / 2, settings_.height / 2)), 7.0, 1e-3);
}

TEST_F(Illuminance, IsSeenThroughVeils) {
    Scene scene = floorOf(makeMaterial({0.3F, 0.3F, 0.3F}));
    scene.spotLights.push_back(makeSpot({0, 5, 0}, {0, 0, 0}, 0.9));
    const glm::dvec3 bare = drawOnce(scene, camera_, settings_).color(20, 20);
    Material veil = makeMaterial({1, 1, 1});
    veil.alphaMode = Material::AlphaMode::kBlend;
    veil.baseColor.w = 0.2F;
    addShape(scene, makeQuad({0, 7, 0}, {6, 0, 0}, {0, 0, -6}), veil);
    EXPECT_EQ(drawOnce(scene, camera_, settings_).color(20, 20), bare);
}

TEST_F(Illuminance, FalseColoursAreThoseOfTheLegend) {
    Scene scene = floorOf(makeMaterial({0.3F, 0.3F, 0.3F}));
    scene.spotLights.push_back(makeSpot({0, 5, 0}, {0, 0, 0}, 0.9));
    settings_.display = true;
    settings_.illuminance->highestLux = 100.0;
    Renderer renderer(scene);
    EXPECT_EQ(renderer.draw(camera_, settings_).describe(), "shadow_map[1] forward false_color");
    EXPECT_FALSE(renderer.ev100());
    const Frame3 frame = readBack(renderer);
    const std::vector<std::uint8_t> display = readDisplay(renderer.targets());
    for (int y = 0; y < settings_.height; ++y) {
        for (int x = 0; x < settings_.width; ++x) {
            const double lux = luminance(frame.color(x, y));
            const glm::dvec3 color = shader::falseColor(shader::falseColorShare(lux, 100.0));
            const auto at = 3 * (std::size_t(y) * std::size_t(settings_.width) + std::size_t(x));
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_NEAR(double(display[at + c]) / 255.0, color[glm::length_t(c)], 1.0 / 255.0);
            }
        }
    }
}

TEST(FalseColor, RunsOverThreeDecadesAndNeverTurnsBack) {
    EXPECT_EQ(shader::falseColorShare(1000.0, 1000.0), 1.0);
    EXPECT_NEAR(shader::falseColorShare(10.0, 1000.0), 1.0 / 3.0, 1e-12);
    EXPECT_EQ(shader::falseColorShare(0.0, 1000.0), 0.0);
    EXPECT_EQ(shader::falseColorShare(1e9, 1000.0), 1.0);
    for (int i = 0; i < 100; ++i) {
        for (int j = 0; j < i; ++j) {
            // Any two that are some way apart can be told apart.
            const glm::dvec3 a = shader::falseColor(i / 100.0);
            const glm::dvec3 b = shader::falseColor(j / 100.0);
            EXPECT_GT(glm::distance(a, b), i - j >= 10 ? 0.15 : 0.0) << i << ", " << j;
        }
    }
}

}  // namespace
}  // namespace ribalta::test
