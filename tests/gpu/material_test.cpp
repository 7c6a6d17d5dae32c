// What each of a material's textures does to a surface, and by which coordinates it is read.
#include <cmath>
#include <numbers>

#include "gpu_test.h"
#include "optics/shader_lib.h"
#include "support/stage.h"

namespace ribalta::test {
namespace {

/// A sheet that faces the camera, 1 m to each side, lit evenly from the camera's side; the picture
/// shows just the sheet.
class MaterialTest : public GpuTest {
  protected:
    MaterialTest() {
        material_ = makeMaterial(glm::vec3(0.5F));
        sheet_ = makeQuad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
        sheet_.tangents.assign(4, glm::vec4(1, 0, 0, 1));
        DirectionalLight lamp;
        lamp.illuminanceLux = 100.0;
        scene_.directionalLights = {lamp};
        camera_.farMetres = 10.0;
        camera_.frame = lookAt({0, 0, 3}, {0, 0, 0});
        camera_.lens = OrthographicLens{1.0, 1.0};
    }

    /// Adds a picture of one colour, or of `left` and `right` halves.
    TextureSlot useImage(const glm::vec4& left, const glm::vec4& right) {
        Texture texture;
        texture.image = int(scene_.images.size());
        texture.sampler.wrapS = Sampler::Wrap::kClampToEdge;
        scene_.images.push_back(
            makeImage(32, 32, [&](int x, int) { return x < 16 ? left : right; }));
        scene_.textures.push_back(texture);
        TextureSlot slot;
        slot.texture = int(scene_.textures.size()) - 1;
        return slot;
    }
    TextureSlot useImage(const glm::vec4& color) { return useImage(color, color); }

    Frame3 draw(const FrameLayers& layers = {}) {
        scene_.nodes.clear();
        scene_.meshes.clear();
        scene_.materials.clear();
        addShape(scene_, sheet_, material_);
        return drawOnce(scene_, camera_, settings_, layers);
    }
    /// Left and right quarter of the picture, red.
    std::pair<double, double> sides() {
        const Frame3 frame = draw();
        return {frame.color(8, 16).x, frame.color(24, 16).x};
    }
    /// What 100 lux from the front are worth on a surface seen from there.
    static double faceOn(double baseColor, double metallic, double roughness) {
        return 100.0 *
               shader::metallicRoughnessBrdf(glm::dvec3(baseColor), metallic, roughness, 1, 1, 1, 1)
                   .x;
    }

    Scene scene_;
    Material material_;
    Primitive sheet_;
    Camera camera_;
    FrameSettings settings_ = measuringSettings(32, 32);
};

TEST_F(MaterialTest, MetallicIsBlueAndRoughnessGreen) {
    material_.metallic = 0.8F;
    material_.roughness = 0.9F;
    material_.metallicRoughnessTexture =
        useImage({0.0F, 128.0F / 255.0F, 1.0F, 1.0F}, {1.0F, 1.0F, 0.0F, 1.0F});
    const auto [left, right] = sides();
    EXPECT_NEAR(left, faceOn(0.5, 0.8, 0.9 * 128.0 / 255.0), 1e-3 * left);
    EXPECT_NEAR(right, faceOn(0.5, 0.0, 0.9), 1e-3 * right);
}

TEST_F(MaterialTest, ANormalMapBendsTheNormal) {
    // (1, 0, 1) on the left, (0, 1, 1) on the right, both at 45 degrees; the map's own +Y is up.
    const float lean = 0.5F + 0.5F * float(std::sqrt(0.5));
    material_.normalTexture = useImage({lean, 0.5F, lean, 1.0F}, {0.5F, lean, lean, 1.0F});
    FrameLayers layers;
    layers.normal = true;
    Frame3 frame = draw(layers);
    const double half = std::sqrt(0.5);
    // The map has 8 bits and no exact zero.
    EXPECT_LT(glm::length(frame.color(8, 16, "normal") - glm::dvec3(half, 0, half)), 0.01);
    EXPECT_LT(glm::length(frame.color(24, 16, "normal") - glm::dvec3(0, half, half)), 0.01);
    // The other handedness turns the bitangent.
    sheet_.tangents.assign(4, glm::vec4(1, 0, 0, -1));
    frame = draw(layers);
    EXPECT_LT(glm::length(frame.color(24, 16, "normal") - glm::dvec3(0, -half, half)), 0.01);
    // Half the scale: atan(1 / 2).
    material_.normalScale = 0.5F;
    frame = draw(layers);
    EXPECT_LT(glm::length(frame.color(8, 16, "normal") - glm::normalize(glm::dvec3(0.5, 0.0, 1.0))),
              0.01);
}

TEST_F(MaterialTest, EmissionIsMultipliedAndDecoded) {
    scene_.directionalLights.clear();
    material_.emission = glm::vec3(1000.0F);
    material_.emissiveTexture =
        useImage(glm::vec4(0, 0, 0, 1), glm::vec4(glm::vec3(188.0F / 255.0F), 1));
    const auto [left, right] = sides();
    EXPECT_EQ(left, 0.0);
    EXPECT_NEAR(right, 1000.0 * shader::srgbDecodeChannel(188.0 / 255.0), 2.0);
}

TEST_F(MaterialTest, OcclusionDimsAmbientLightOnly) {
    material_.occlusionTexture = useImage({0, 1, 1, 1}, {1, 0, 0, 1});
    material_.occlusionStrength = 0.75F;
    auto [left, right] = sides();
    EXPECT_NEAR(left, right, 1e-5 * right);
    scene_.directionalLights.clear();
    settings_.ambientLux = 10.0;
    std::tie(left, right) = sides();
    EXPECT_NEAR(left, 0.25 * right, 1e-3 * right);
    EXPECT_GT(right, 0.0);
}

TEST_F(MaterialTest, CoordinatesAreTransformedAndMayBeTheSecondOnes) {
    material_.unlit = true;
    material_.baseColor = glm::vec4(1.0F);
    material_.baseColorTexture = useImage(glm::vec4(0, 0, 0, 1), glm::vec4(1.0F));
    EXPECT_EQ(sides(), std::pair(0.0, 1.0));
    // u' = 1 - u.
    material_.baseColorTexture->textureFromUv = glm::mat3(-1, 0, 0, 0, 1, 0, 1, 0, 1);
    EXPECT_EQ(sides(), std::pair(1.0, 0.0));
    // The second set runs the other way.
    material_.baseColorTexture->textureFromUv = glm::mat3(1.0F);
    for (const glm::vec2& uv : sheet_.uv0) {
        sheet_.uv1.emplace_back(1.0F - uv.x, uv.y);
    }
    material_.baseColorTexture->uvSet = 1;
    EXPECT_EQ(sides(), std::pair(1.0, 0.0));
}

TEST_F(MaterialTest, VertexColoursAreMultiplied) {
    material_.unlit = true;
    material_.baseColor = {0.5F, 0.5F, 0.5F, 1.0F};
    sheet_.colors.assign(4, glm::vec4(0.5F, 1.0F, 0.25F, 1.0F));
    const glm::dvec3 drawn = draw().color(16, 16);
    EXPECT_NEAR(drawn.x, 0.25, 1e-4);
    EXPECT_NEAR(drawn.y, 0.5, 1e-4);
    EXPECT_NEAR(drawn.z, 0.125, 1e-4);
}

TEST_F(MaterialTest, AMaskCutsHolesAndNothingElse) {
    material_.unlit = true;
    material_.alphaMode = Material::AlphaMode::kMask;
    material_.alphaCutoff = 0.5F;
    material_.baseColorTexture = useImage({1, 1, 1, 0.4F}, {1, 1, 1, 0.6F});
    FrameLayers layers;
    layers.depth = true;
    const Frame3 frame = draw(layers);
    EXPECT_EQ(frame.color(8, 16).x, 0.0);
    EXPECT_TRUE(std::isinf(frame.depth(8, 16)));
    EXPECT_NEAR(frame.color(24, 16).x, 0.5, 1e-5);
    EXPECT_NEAR(frame.depth(24, 16), 3.0, 1e-4);
}

}  // namespace
}  // namespace ribalta::test
