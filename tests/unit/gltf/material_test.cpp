// Materials, their textures and samplers.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "gltf_file.h"
#include "support/make_png.h"

namespace ribalta::test {
namespace {

using nlohmann::json;

std::string pngUri() {
    return "data:image/png;base64," +
           base64(makePng({.width = 1, .height = 1, .rows = {std::string("\x10\x20\x30\xff", 4)}}));
}

// A triangle with both sets of texture coordinates, the material and one texture.
GltfFile fileWithMaterial(const json& material) {
    GltfFile file = triangleFile();
    json& primitive = file.json["meshes"][0]["primitives"][0];
    primitive["attributes"]["TEXCOORD_0"] = primitive["attributes"]["TEXCOORD_1"] =
        file.addAccessor(std::vector<float>{0, 0, 1, 0, 0, 1}, "VEC2", 5126, 3);
    primitive["material"] = file.push("materials", material);
    file.push("images", {{"uri", pngUri()}});
    file.push("textures", {{"source", 0}});
    return file;
}

Material materialOf(const json& material) {
    return load(fileWithMaterial(material)).scene.materials.at(0);
}

TEST(MaterialTest, DefaultsAreTheSpecifications) {
    const Material material = materialOf(json::object());
    EXPECT_EQ(material.baseColor, glm::vec4(1.0F));
    EXPECT_EQ(material.metallic, 1.0F);
    EXPECT_EQ(material.roughness, 1.0F);
    EXPECT_EQ(material.emission, glm::vec3(0.0F));
    EXPECT_EQ(material.alphaMode, Material::AlphaMode::kOpaque);
    EXPECT_EQ(material.alphaCutoff, 0.5F);
    EXPECT_FALSE(material.doubleSided);
    EXPECT_FALSE(material.unlit);
    EXPECT_FALSE(material.baseColorTexture);
}

TEST(MaterialTest, FactorsAndModes) {
    const Material material =
        materialOf({{"name", "paint"},
                    {"pbrMetallicRoughness",
                     {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}},
                      {"metallicFactor", 0.5},
                      {"roughnessFactor", 0.25}}},
                    {"emissiveFactor", {1, 0.5, 0}},
                    {"alphaMode", "MASK"},
                    {"alphaCutoff", 0.75},
                    {"doubleSided", true},
                    {"extensions",
                     {{"KHR_materials_emissive_strength", {{"emissiveStrength", 8}}},
                      {"KHR_materials_unlit", json::object()}}}});
    EXPECT_EQ(material.name, "paint");
    EXPECT_EQ(material.baseColor, glm::vec4(0.1F, 0.2F, 0.3F, 0.4F));
    EXPECT_EQ(material.metallic, 0.5F);
    EXPECT_EQ(material.roughness, 0.25F);
    EXPECT_EQ(material.emission, glm::vec3(8.0F, 4.0F, 0.0F));
    EXPECT_EQ(material.alphaMode, Material::AlphaMode::kMask);
    EXPECT_EQ(material.alphaCutoff, 0.75F);
    EXPECT_TRUE(material.doubleSided);
    EXPECT_TRUE(material.unlit);
    EXPECT_EQ(materialOf({{"alphaMode", "BLEND"}}).alphaMode, Material::AlphaMode::kBlend);
}

TEST(MaterialTest, AllFiveTexturesAndTheirScales) {
    const json slot = {{"index", 0}, {"texCoord", 1}};
    const LoadedScene loaded = load(fileWithMaterial(
        {{"pbrMetallicRoughness", {{"baseColorTexture", slot}, {"metallicRoughnessTexture", slot}}},
         {"normalTexture", {{"index", 0}, {"scale", -0.5}}},
         {"occlusionTexture", {{"index", 0}, {"strength", 0.25}}},
         {"emissiveTexture", slot}}));
    const Material& material = loaded.scene.materials.at(0);
    ASSERT_TRUE(material.baseColorTexture && material.metallicRoughnessTexture &&
                material.normalTexture && material.occlusionTexture && material.emissiveTexture);
    EXPECT_EQ(material.baseColorTexture->uvSet, 1);
    EXPECT_EQ(material.normalTexture->uvSet, 0);
    EXPECT_EQ(material.normalScale, -0.5F);
    EXPECT_EQ(material.occlusionStrength, 0.25F);
    EXPECT_EQ(loaded.scene.textures.size(), 1U);
    EXPECT_EQ(loaded.scene.images.size(), 1U);
    EXPECT_EQ(loaded.scene.images[0].pixels[1], std::byte(0x20));
    EXPECT_EQ(reportText(loaded), "");
}

TEST(MaterialTest, TextureTransform) {
    const Material material = materialOf({{"emissiveTexture",
                                           {{"index", 0},
                                            {"extensions",
                                             {{"KHR_texture_transform",
                                               {{"offset", {0.5, 0.25}},
                                                {"rotation", std::numbers::pi / 2},
                                                {"scale", {2, 3}},
                                                {"texCoord", 1}}}}}}}});
    ASSERT_TRUE(material.emissiveTexture);
    EXPECT_EQ(material.emissiveTexture->uvSet, 1);
    // Scale, then turn, then move: (1, 0) -> (2, 0) -> (0, -2) -> (0.5, -1.75).
    const glm::vec3 moved = material.emissiveTexture->textureFromUv * glm::vec3(1.0F, 0.0F, 1.0F);
    EXPECT_NEAR(moved.x, 0.5F, 1e-6F);
    EXPECT_NEAR(moved.y, -1.75F, 1e-6F);
    const glm::vec3 other = material.emissiveTexture->textureFromUv * glm::vec3(0.0F, 1.0F, 1.0F);
    EXPECT_NEAR(other.x, 3.5F, 1e-6F);
    EXPECT_NEAR(other.y, 0.25F, 1e-6F);
}

TEST(MaterialTest, Samplers) {
    const auto samplerOf = [](const json& sampler) {
        GltfFile file = fileWithMaterial({{"emissiveTexture", {{"index", 0}}}});
        file.push("samplers", sampler);
        file.json["textures"][0]["sampler"] = 0;
        return load(file).scene.textures.at(0).sampler;
    };
    EXPECT_EQ(samplerOf(json::object()), Sampler());
    const Sampler sharp =
        samplerOf({{"magFilter", 9728}, {"minFilter", 9728}, {"wrapS", 33071}, {"wrapT", 33648}});
    EXPECT_EQ(sharp.magnify, Sampler::Filter::kNearest);
    EXPECT_EQ(sharp.minify, Sampler::Filter::kNearest);
    EXPECT_FALSE(sharp.mipmaps);
    EXPECT_EQ(sharp.wrapS, Sampler::Wrap::kClampToEdge);
    EXPECT_EQ(sharp.wrapT, Sampler::Wrap::kMirroredRepeat);
    const Sampler mixed = samplerOf({{"minFilter", 9986}});
    EXPECT_EQ(mixed.minify, Sampler::Filter::kNearest);
    EXPECT_EQ(mixed.betweenLevels, Sampler::Filter::kLinear);
    EXPECT_TRUE(mixed.mipmaps);
    const Sampler other = samplerOf({{"minFilter", 9985}});
    EXPECT_EQ(other.minify, Sampler::Filter::kLinear);
    EXPECT_EQ(other.betweenLevels, Sampler::Filter::kNearest);
}

TEST(MaterialTest, OnlyDrawnMaterialsAreKept) {
    GltfFile file = fileWithMaterial({{"name", "drawn"}});
    file.push("materials", {{"name", "unused"}, {"emissiveTexture", {{"index", 0}}}});
    const LoadedScene loaded = load(file);
    ASSERT_EQ(loaded.scene.materials.size(), 1U);
    EXPECT_EQ(loaded.scene.materials[0].name, "drawn");
    EXPECT_TRUE(loaded.scene.images.empty());
}

TEST(MaterialTest, FactorsOutOfRangeAreClampedAndTold) {
    const LoadedScene loaded = load(fileWithMaterial(
        {{"pbrMetallicRoughness", {{"roughnessFactor", 1.5}, {"baseColorFactor", {1, 1, 1, 2}}}},
         {"emissiveFactor", "bright"},
         {"alphaMode", "GLASS"}}));
    EXPECT_EQ(loaded.scene.materials[0].roughness, 1.0F);
    EXPECT_EQ(loaded.scene.materials[0].baseColor.w, 1.0F);
    const Report::Kind repaired = Report::Kind::kRepaired;
    expectLine(loaded, repaired, "/materials/0/pbrMetallicRoughness/roughnessFactor", "1.5");
    expectLine(loaded, repaired, "/materials/0/pbrMetallicRoughness/baseColorFactor/3", "is 2");
    expectLine(loaded, repaired, "/materials/0/emissiveFactor", "array of numbers");
    expectLine(loaded, repaired, "/materials/0/alphaMode", "OPAQUE, MASK, BLEND");
}

TEST(MaterialTest, TexturesThatCannotBeDrawnAreLeftOut) {
    GltfFile file = fileWithMaterial({{"normalTexture", {{"index", 7}}},
                                      {"occlusionTexture", {{"index", 0}, {"texCoord", 2}}},
                                      {"emissiveTexture", {{"index", 1}}}});
    file.push("textures", json::object());
    const LoadedScene loaded = load(file);
    const Material& material = loaded.scene.materials[0];
    EXPECT_FALSE(material.normalTexture || material.occlusionTexture || material.emissiveTexture);
    expectLine(loaded, Report::Kind::kRepaired, "/materials/0/normalTexture/index",
               "the file has 2 textures");
    expectLine(loaded, Report::Kind::kIgnored, "/materials/0/occlusionTexture", "TEXCOORD_2");
    expectLine(loaded, Report::Kind::kIgnored, "/materials/0/emissiveTexture", "no image");
}

TEST(MaterialTest, TextureWithoutCoordinatesIsTold) {
    GltfFile file = fileWithMaterial({{"emissiveTexture", {{"index", 0}}}});
    file.json["meshes"][0]["primitives"][0]["attributes"].erase("TEXCOORD_0");
    expectLine(load(file), Report::Kind::kHint, "/meshes/0", "lacks TEXCOORD_0");
}

}  // namespace
}  // namespace ribalta::test
