// Surfaces of several layers, drawn, against the reference; and a thin wall against its formula.
#include <cmath>

#include "gpu_test.h"
#include "reference/reference_picture.h"
#include "support/stage.h"

namespace ribalta::test {
namespace {

class Layers : public GpuTest {
  protected:
    Layers() {
        PointLight bulb;
        bulb.position = {1.5, 3.0, 1.0};
        bulb.intensityCandela = 500.0;
        scene_.pointLights.push_back(bulb);
        DirectionalLight sun;
        sun.direction = glm::normalize(glm::dvec3(-0.3, -1.0, -0.6));
        sun.illuminanceLux = 30.0;
        scene_.directionalLights.push_back(sun);
        settings_.ambientLux = 5.0;
    }

    void addQuad(const glm::vec3& centre, const Material& material) {
        Primitive quad = makeQuad(centre, {6, 0, 0}, {0, 0, -6});
        quad.tangents.assign(quad.positions.size(), glm::vec4(0.8F, 0.0F, -0.6F, 1.0F));
        addShape(scene_, quad, material);
    }

    /// Every pixel is the reference's, which has the formula in double precision.
    void expectReference() {
        const Frame3 frame = drawOnce(scene_, camera_, settings_);
        ReferenceSettings reference;
        reference.camera = camera_;
        reference.width = settings_.width;
        reference.height = settings_.height;
        reference.haze = settings_.haze;
        reference.ambientLux = settings_.ambientLux;
        const ReferencePicture truth = drawReference(scene_, reference);
        for (int y = 0; y < settings_.height; ++y) {
            for (int x = 0; x < settings_.width; ++x) {
                const glm::dvec3 expected =
                    truth.surfaces[std::size_t(y) * std::size_t(settings_.width) + std::size_t(x)];
                const glm::dvec3 drawn = frame.color(x, y);
                for (int c = 0; c < 3; ++c) {
                    ASSERT_NEAR(drawn[c], expected[c], 0.005 * expected[c] + 1e-5)
                        << x << ", " << y << ", channel " << c;
                }
            }
        }
    }

    Scene scene_;
    Camera camera_ = makeCamera({0.0, 2.0, 3.0}, {0.0, 0.0, 0.0});
    FrameSettings settings_ = measuringSettings();
};

Material layered(const MaterialLayers& layers, float metallic = 0.0F, float roughness = 0.4F) {
    Material material = makeMaterial({0.8F, 0.4F, 0.1F}, metallic, roughness);
    material.layers = layers;
    return material;
}

TEST_F(Layers, EachIsTheReferences) {
    MaterialLayers coat;
    coat.clearcoat = 0.8F;
    coat.clearcoatRoughness = 0.3F;
    MaterialLayers sheen;
    sheen.sheenColor = {0.2F, 0.5F, 0.9F};
    sheen.sheenRoughness = 0.35F;
    MaterialLayers anisotropy;
    anisotropy.anisotropy = 0.8F;
    anisotropy.anisotropyRotation = 0.5F;
    MaterialLayers specular;
    specular.ior = 2.0F;
    specular.specular = 0.7F;
    specular.specularColor = {0.9F, 0.3F, 0.6F};
    MaterialLayers all = coat;
    all.sheenColor = sheen.sheenColor;
    all.sheenRoughness = 0.8F;
    all.anisotropy = 0.5F;
    all.specularColor = specular.specularColor;
    for (const MaterialLayers& layers : {coat, sheen, anisotropy, specular, all}) {
        for (const float metallic : {0.0F, 0.7F}) {
            scene_.nodes.clear();
            addQuad({0, 0, 0}, layered(layers, metallic));
            expectReference();
        }
    }
}

TEST_F(Layers, AThinWallTintsWhatIsBehind) {
    addQuad({0, 0, 0}, makeMaterial({0.7F, 0.6F, 0.5F}));
    MaterialLayers glass;
    glass.transmission = 0.9F;
    glass.clearcoat = 0.5F;
    glass.clearcoatRoughness = 0.5F;
    addQuad({0, 0.5F, 0}, layered(glass));
    expectReference();
    // An index of 1 reflects nothing straight on, and little elsewhere: the base colour is left.
    scene_.nodes.clear();
    scene_.pointLights.clear();
    scene_.directionalLights.clear();
    settings_.ambientLux = 0.0;
    camera_ = makeCamera({0.0, 3.0, 0.0}, {0.0, 0.0, -0.001});
    Material ground = makeMaterial(glm::vec3(0.5F));
    ground.unlit = true;
    addQuad({0, 0, 0}, ground);
    MaterialLayers clear;
    clear.ior = 1.0F;
    clear.transmission = 1.0F;
    addQuad({0, 0.5F, 0}, layered(clear));
    const glm::dvec3 seen = drawOnce(scene_, camera_, settings_).color(32, 24);
    EXPECT_NEAR(seen.x, 0.5 * 0.8, 1e-4);
    EXPECT_NEAR(seen.y, 0.5 * 0.4, 1e-4);
    EXPECT_NEAR(seen.z, 0.5 * 0.1, 1e-4);
}

}  // namespace
}  // namespace ribalta::test
