// The luminance of surfaces under every kind of lamp against the formula in double precision, at
// the centre of every pixel.
#include <cmath>

#include "base/angles.h"
#include "gpu_test.h"
#include "optics/shader_lib.h"
#include "support/stage.h"

namespace ribalta::test {
namespace {

// What the project promises of a surface's luminance.
constexpr double kPromised = 0.005;

/// glTF's model at roughness 1, where GGX is even and Smith's term simple, written out by hand.
glm::dvec3 roughBrdf(const glm::dvec3& baseColor, double nDotL, double nDotV, double vDotH) {
    const double fresnel = 0.04 + 0.96 * std::pow(1.0 - vDotH, 5.0);
    const double specular = 1.0 / kPi * 0.5 / (nDotL + nDotV);
    return (1.0 - fresnel) * baseColor / kPi + fresnel * specular;
}

/// What light from one direction is worth at a point of the floor: illuminance in lux on a surface
/// that faces it.
struct Light {
    glm::dvec3 towards{0.0};
    glm::dvec3 lux{0.0};
};

class SurfaceLight : public GpuTest {
  protected:
    SurfaceLight() { setFloor(makeMaterial({0.8F, 0.5F, 0.2F})); }

    void setFloor(const Material& material) {
        scene_.nodes.clear();
        scene_.meshes.clear();
        scene_.materials.clear();
        floorMaterial_ = material;
        addShape(scene_, makeQuad({0, 0, 0}, {6, 0, 0}, {0, 0, -6}), material);
    }

    /// Compares every pixel of the floor y = 0 with `lightAt` there, through the haze.
    void expectFloor(const std::function<Light(const glm::dvec3& point)>& lightAt) {
        FrameLayers layers;
        layers.beams = settings_.haze.scatteringPerMetre > 0.0;
        const Frame3 frame = drawOnce(scene_, camera_, settings_, layers);
        const double extinction = settings_.haze.extinctionPerMetre();
        double brightest = 0.0;
        std::vector<glm::dvec3> expected;
        std::vector<glm::dvec3> drawn;
        for (int y = 0; y < settings_.height; ++y) {
            for (int x = 0; x < settings_.width; ++x) {
                const PixelRay ray = pixelRay(camera_, settings_.width, settings_.height, x, y);
                const double eye = -ray.origin.y / ray.direction.y;
                const glm::dvec3 point = ray.origin + eye * ray.direction;
                if (eye < 0.0 || std::abs(point.x) > 5.9 || std::abs(point.z) > 5.9) {
                    continue;
                }
                const Light light = lightAt(point);
                const double nDotL = light.towards.y;
                const double nDotV = -ray.direction.y;
                const glm::dvec3 halfway = glm::normalize(light.towards - ray.direction);
                const double vDotH = -glm::dot(halfway, ray.direction);
                const glm::dvec3 base(glm::vec3(floorMaterial_.baseColor));
                const glm::dvec3 brdf =
                    floorMaterial_.roughness == 1.0F && floorMaterial_.metallic == 0.0F
                        ? roughBrdf(base, nDotL, nDotV, vDotH)
                        : shader::metallicRoughnessBrdf(base, double(floorMaterial_.metallic),
                                                        double(floorMaterial_.roughness), nDotL,
                                                        nDotV, halfway.y, vDotH);
                expected.push_back(nDotL > 0.0
                                       ? light.lux * nDotL * brdf * std::exp(-extinction * eye)
                                       : glm::dvec3(0.0));
                drawn.push_back(frame.color(x, y) -
                                (layers.beams ? frame.color(x, y, "beams") : glm::dvec3(0.0)));
                brightest = std::max(brightest, expected.back().x);
            }
        }
        ASSERT_GT(expected.size(), 500U);
        ASSERT_GT(brightest, 0.0);
        for (std::size_t i = 0; i < expected.size(); ++i) {
            for (int c = 0; c < 3; ++c) {
                // The steep edge of a cone and what is left after taking the beams away.
                ASSERT_NEAR(drawn[i][c], expected[i][c],
                            kPromised * expected[i][c] + 1e-4 * brightest)
                    << "channel " << c << " of floor pixel " << i;
            }
        }
    }

    /// KHR_lights_punctual's spot, through the haze.
    Light spotAt(const SpotLight& lamp, const glm::dvec3& point) const {
        const glm::dvec3 to = lamp.frame.position - point;
        const double distance = glm::length(to);
        const double cosAngle = glm::dot(-to / distance, lamp.frame.forward());
        const double cosOuter = std::cos(lamp.outerConeAngle);
        const double cosInner = std::cos(lamp.innerConeAngle);
        const double ramp =
            std::clamp((cosAngle - cosOuter) / std::max(0.001, cosInner - cosOuter), 0.0, 1.0);
        return {to / distance, glm::dvec3(lamp.color) * lamp.intensityCandela * ramp * ramp *
                                   overDistance(distance, lamp.rangeMetres)};
    }
    double overDistance(double distance, double range) const {
        const double window = 1.0 - std::pow(std::min(distance / range, 1.0), 4.0);
        return window / (distance * distance) *
               std::exp(-settings_.haze.extinctionPerMetre() * distance);
    }

    Scene scene_;
    Camera camera_ = makeCamera({1.0, 4.0, 5.0}, {0.0, 0.0, 0.0}, 0.9);
    FrameSettings settings_ = measuringSettings();
    Material floorMaterial_;
};

TEST_F(SurfaceLight, ASpotOnARoughFloor) {
    SpotLight lamp = makeSpot({-1, 3, 1}, {0.5, 0, -0.5}, 0.5, 5000.0);
    lamp.color = {1.0F, 0.7F, 0.3F};
    for (const double inner : {0.0, 0.3, 0.5}) {
        lamp.innerConeAngle = inner;
        for (const double range : {3.8, double(INFINITY)}) {
            lamp.rangeMetres = range;
            scene_.spotLights = {lamp};
            SCOPED_TRACE("inner " + std::to_string(inner) + ", range " + std::to_string(range));
            expectFloor([&](const glm::dvec3& point) { return spotAt(lamp, point); });
        }
    }
}

TEST_F(SurfaceLight, HazeTakesItsShareOnBothLegs) {
    const SpotLight lamp = makeSpot({-1, 3, 1}, {0.5, 0, -0.5}, 0.5, 5000.0);
    scene_.spotLights = {lamp};
    settings_.haze.absorptionPerMetre = 0.15;
    expectFloor([&](const glm::dvec3& point) { return spotAt(lamp, point); });
    settings_.haze.scatteringPerMetre = 0.05;
    expectFloor([&](const glm::dvec3& point) { return spotAt(lamp, point); });
}

TEST_F(SurfaceLight, EveryMaterial) {
    const SpotLight lamp = makeSpot({-1, 3, -2}, {0.0, 0, 0.5}, 0.6, 5000.0);
    scene_.spotLights = {lamp};
    for (const float metallic : {0.0F, 0.5F, 1.0F}) {
        for (const float roughness : {0.25F, 0.6F, 1.0F}) {
            setFloor(makeMaterial({0.9F, 0.6F, 0.3F}, metallic, roughness));
            SCOPED_TRACE("metallic " + std::to_string(metallic) + ", roughness " +
                         std::to_string(roughness));
            expectFloor([&](const glm::dvec3& point) { return spotAt(lamp, point); });
        }
    }
}

TEST_F(SurfaceLight, PointLamps) {
    PointLight lamp;
    lamp.position = {1.5, 1.0, -0.5};
    lamp.intensityCandela = 300.0;
    lamp.color = {0.5F, 1.0F, 0.25F};
    for (const double range : {4.0, double(INFINITY)}) {
        lamp.rangeMetres = range;
        scene_.pointLights = {lamp};
        settings_.haze.absorptionPerMetre = std::isfinite(range) ? 0.0 : 0.1;
        expectFloor([&](const glm::dvec3& point) {
            const glm::dvec3 to = lamp.position - point;
            const double distance = glm::length(to);
            return Light{to / distance, glm::dvec3(lamp.color) * lamp.intensityCandela *
                                            overDistance(distance, lamp.rangeMetres)};
        });
    }
}

TEST_F(SurfaceLight, DirectionalLamps) {
    DirectionalLight lamp;
    lamp.direction = glm::normalize(glm::dvec3(0.4, -1.0, -0.3));
    lamp.illuminanceLux = 1000.0;
    lamp.color = {1.0F, 0.9F, 0.8F};
    scene_.directionalLights = {lamp};
    expectFloor([&](const glm::dvec3&) {
        return Light{-lamp.direction, glm::dvec3(lamp.color) * lamp.illuminanceLux};
    });
    scene_.directionalLights[0].direction = {0.0, 1.0, 0.0};
    const Frame3 fromBelow = drawOnce(scene_, camera_, settings_);
    EXPECT_EQ(fromBelow.color(32, 24), glm::dvec3(0.0));
}

TEST_F(SurfaceLight, InverseSquare) {
    // The camera looks straight down beside the lamp; the middle of the floor is under it.
    camera_ = makeCamera({0, 5, 0.0}, {0, 0, 0});
    settings_ = measuringSettings(33, 33);
    double luminance[2] = {};
    for (const int i : {0, 1}) {
        scene_.spotLights = {makeSpot({0, i == 0 ? 2.0 : 4.0, 0}, {0, 0, 0}, 0.4, 1000.0)};
        luminance[i] = drawOnce(scene_, camera_, settings_).color(16, 16).x;
    }
    EXPECT_NEAR(luminance[0], 4.0 * luminance[1], 1e-3 * luminance[0]);
    // 250 lux on a rough floor seen and lit from straight above.
    EXPECT_NEAR(luminance[0], 250.0 * roughBrdf(glm::dvec3(0.8), 1.0, 1.0, 1.0).x,
                kPromised * luminance[0]);
}

TEST_F(SurfaceLight, WithoutLightEverythingIsExactlyBlack) {
    scene_.spotLights = {makeSpot({0, 3, 0}, {0, 0, 0}, 0.2, 5000.0)};
    const Frame3 frame = drawOnce(scene_, camera_, settings_);
    int black = 0;
    int lit = 0;
    for (int y = 0; y < settings_.height; ++y) {
        for (int x = 0; x < settings_.width; ++x) {
            const PixelRay ray = pixelRay(camera_, settings_.width, settings_.height, x, y);
            const glm::dvec3 point = ray.origin - ray.origin.y / ray.direction.y * ray.direction;
            const double across = std::hypot(point.x, point.z) / 3.0;
            if (across > 1.001 * std::tan(0.2)) {
                ASSERT_EQ(frame.color(x, y), glm::dvec3(0.0)) << x << ", " << y;
                ++black;
            } else if (across < 0.9 * std::tan(0.2)) {
                EXPECT_GT(frame.color(x, y).x, 0.0);
                ++lit;
            }
        }
    }
    EXPECT_GT(black, 500);
    EXPECT_GT(lit, 10);
}

TEST_F(SurfaceLight, AmbientLightAndEmissionAndUnlit) {
    settings_.ambientLux = 100.0;
    glm::dvec3 drawn = drawOnce(scene_, camera_, settings_).color(32, 24);
    EXPECT_NEAR(drawn.x, (0.8 + 0.04) * 100.0 / kPi, 0.01);

    settings_.ambientLux = 0.0;
    Material glowing = makeMaterial(glm::vec3(0.5F));
    glowing.emission = {10.0F, 200.0F, 3000.0F};
    setFloor(glowing);
    EXPECT_EQ(drawOnce(scene_, camera_, settings_).color(32, 24), glm::dvec3(10, 200, 3000));

    Material unlit = makeMaterial({0.25F, 0.5F, 0.75F});
    unlit.unlit = true;
    setFloor(unlit);
    scene_.spotLights = {makeSpot({0, 3, 0}, {0, 0, 0}, 0.5, 5000.0)};
    EXPECT_EQ(drawOnce(scene_, camera_, settings_).color(32, 24), glm::dvec3(0.25, 0.5, 0.75));
}

// Light that falls differently on every side, on a sphere seen askew, against the sum by hand; and
// beside the even light of the settings, which it adds to.
TEST_F(SurfaceLight, Environments) {
    IrradianceCoefficients coefficients{};
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
        const auto number = double(i);
        coefficients[i] = {i == 0 ? 900.0 : 60.0 - 13.0 * number, i == 0 ? 700.0 : 10.0 * number,
                           i == 0 ? 800.0 : -20.0 * number};
    }
    Environment environment;
    environment.lux = irradianceForm(coefficients, glm::dmat3(1.0));
    scene_ = Scene();
    const glm::dvec3 color(0.8, 0.5, 0.2);
    addShape(scene_, makeSphere({0, 0, 0}, 1.0F, 128), makeMaterial(glm::vec3(color)));
    camera_ = makeCamera({2, 3, 4}, {0, 0, 0}, 0.5);
    EXPECT_EQ(drawOnce(scene_, camera_, settings_).color(32, 24), glm::dvec3(0.0));
    scene_.environment = environment;
    int compared = 0;
    for (const double ambient : {0.0, 50.0}) {
        settings_.ambientLux = ambient;
        const Frame3 frame = drawOnce(scene_, camera_, settings_);
        for (int y = 0; y < settings_.height; ++y) {
            for (int x = 0; x < settings_.width; ++x) {
                const PixelRay ray = pixelRay(camera_, settings_.width, settings_.height, x, y);
                const double along = -glm::dot(ray.origin, ray.direction);
                const double across =
                    glm::dot(ray.origin, ray.origin) - along * along;  // of the middle, squared
                if (across > 0.9) {
                    continue;
                }
                const glm::dvec3 n = ray.origin + (along - std::sqrt(1.0 - across)) * ray.direction;
                // The paper's equation 11, number by number.
                const auto& c = coefficients;
                const glm::dvec3 lux =
                    0.282095 * c[0] + 0.488603 * (n.y * c[1] + n.z * c[2] + n.x * c[3]) +
                    1.092548 * (n.x * n.y * c[4] + n.y * n.z * c[5] + n.x * n.z * c[7]) +
                    0.315392 * (3.0 * n.z * n.z - 1.0) * c[6] +
                    0.546274 * (n.x * n.x - n.y * n.y) * c[8] + ambient * (0.75 + 0.25 * n.y);
                const glm::dvec3 expected = (color + 0.04) * lux / kPi;
                const glm::dvec3 drawn = frame.color(x, y);
                for (int channel = 0; channel < 3; ++channel) {
                    ASSERT_NEAR(drawn[channel], expected[channel], kPromised * expected[channel])
                        << x << ", " << y;
                }
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 300);
}

TEST_F(SurfaceLight, BackFacesAndMirroredNodes) {
    scene_.directionalLights.emplace_back();
    scene_.directionalLights[0].direction = {0.0, -1.0, 0.0};
    scene_.directionalLights[0].illuminanceLux = 100.0;
    const double upright = drawOnce(scene_, camera_, settings_).color(32, 24).x;
    EXPECT_GT(upright, 1.0);
    // A mirrored node keeps its front in front, and its normals outwards.
    scene_.nodes[0].worldFromLocal[0][0] = -1.0;
    EXPECT_NEAR(drawOnce(scene_, camera_, settings_).color(32, 24).x, upright, 1e-4 * upright);
    // Turned over it shows its back: not drawn, or dark from behind where double-sided.
    scene_.nodes[0].worldFromLocal = glm::dmat4(1.0);
    scene_.nodes[0].worldFromLocal[1][1] = -1.0;
    scene_.nodes[0].worldFromLocal[2][2] = -1.0;
    EXPECT_EQ(drawOnce(scene_, camera_, settings_).color(32, 24).x, 0.0);
    scene_.materials[0].doubleSided = true;
    EXPECT_NEAR(drawOnce(scene_, camera_, settings_).color(32, 24).x, upright, 1e-4 * upright);
}

TEST_F(SurfaceLight, BlendedSurfacesLetThroughWhatIsBehind) {
    Material ground = makeMaterial(glm::vec3(0.0F));
    ground.unlit = true;
    ground.baseColor = {0.2F, 0.2F, 0.2F, 1.0F};
    setFloor(ground);
    Material glass = ground;
    glass.alphaMode = Material::AlphaMode::kBlend;
    glass.baseColor = {1.0F, 0.0F, 0.0F, 0.25F};
    addShape(scene_, makeQuad({0, 0.1F, 0}, {6, 0, 0}, {0, 0, -6}), glass);
    FrameLayers layers;
    layers.depth = true;
    const Frame3 frame = drawOnce(scene_, camera_, settings_, layers);
    const glm::dvec3 drawn = frame.color(32, 24);
    EXPECT_NEAR(drawn.x, 0.25 + 0.75 * 0.2, 1e-5);
    EXPECT_NEAR(drawn.y, 0.75 * 0.2, 1e-5);
    // What is seen through ends neither depth nor beams.
    scene_.nodes.pop_back();
    EXPECT_EQ(frame.depth(32, 24), drawOnce(scene_, camera_, settings_, layers).depth(32, 24));
}

}  // namespace
}  // namespace ribalta::test
