// The material extensions that lay something on a surface: what is read of them, and what is said.
#include <gtest/gtest.h>

#include "gltf_file.h"
#include "support/make_png.h"

namespace ribalta::test {
namespace {

using nlohmann::json;

// A triangle with coordinates and one material with these extensions.
GltfFile layeredFile(const json& extensions) {
    GltfFile file = triangleFile();
    json& primitive = file.json["meshes"][0]["primitives"][0];
    primitive["attributes"]["TEXCOORD_0"] =
        file.addAccessor(std::vector<float>{0, 0, 1, 0, 0, 1}, "VEC2", 5126, 3);
    primitive["attributes"]["NORMAL"] =
        file.addAccessor(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 5126, 3);
    primitive["material"] = 0;
    file.push("materials", {{"extensions", extensions}});
    file.push("images", {{"bufferView", file.addView(makePng({.rows = {std::string(4, '\x80')}}))},
                         {"mimeType", "image/png"}});
    file.push("textures", {{"source", 0}});
    for (const auto& [name, object] : extensions.items()) {
        file.json["extensionsUsed"].push_back(name);
    }
    return file;
}

const std::optional<MaterialLayers>& layersOf(const LoadedScene& loaded) {
    return loaded.scene.materials.at(0).layers;
}

TEST(LayersTest, DefaultsCostNothing) {
    const LoadedScene loaded = load(layeredFile({{"KHR_materials_ior", {{"ior", 1.5}}},
                                                 {"KHR_materials_specular", json::object()},
                                                 {"KHR_materials_clearcoat", json::object()},
                                                 {"KHR_materials_sheen", json::object()},
                                                 {"KHR_materials_anisotropy", json::object()},
                                                 {"KHR_materials_transmission", json::object()}}));
    EXPECT_EQ(reportText(loaded), "");
    EXPECT_FALSE(layersOf(loaded).has_value());
    EXPECT_FALSE(loaded.scene.materials[0].isSeeThrough());
}

TEST(LayersTest, AllValuesAndTexturesAreRead) {
    const json slot = {{"index", 0}};
    const LoadedScene loaded = load(layeredFile(
        {{"KHR_materials_ior", {{"ior", 1.33}}},
         {"KHR_materials_specular",
          {{"specularFactor", 0.5},
           {"specularColorFactor", {0.1, 0.2, 2.0}},
           {"specularTexture", slot},
           {"specularColorTexture", slot}}},
         {"KHR_materials_clearcoat",
          {{"clearcoatFactor", 0.7},
           {"clearcoatRoughnessFactor", 0.3},
           {"clearcoatTexture", slot},
           {"clearcoatRoughnessTexture", slot},
           {"clearcoatNormalTexture", {{"index", 0}, {"scale", 0.4}}}}},
         {"KHR_materials_sheen",
          {{"sheenColorFactor", {0.3, 0.4, 0.5}},
           {"sheenRoughnessFactor", 0.6},
           {"sheenColorTexture", slot},
           {"sheenRoughnessTexture", slot}}},
         {"KHR_materials_anisotropy",
          {{"anisotropyStrength", 0.8}, {"anisotropyRotation", 1.0}, {"anisotropyTexture", slot}}},
         {"KHR_materials_transmission",
          {{"transmissionFactor", 0.9}, {"transmissionTexture", slot}}}}));
    ASSERT_TRUE(layersOf(loaded));
    const MaterialLayers& layers = *layersOf(loaded);
    EXPECT_EQ(layers.ior, 1.33F);
    EXPECT_EQ(layers.specular, 0.5F);
    EXPECT_EQ(layers.specularColor, glm::vec3(0.1F, 0.2F, 2.0F));
    EXPECT_EQ(layers.clearcoat, 0.7F);
    EXPECT_EQ(layers.clearcoatRoughness, 0.3F);
    EXPECT_EQ(layers.clearcoatNormalScale, 0.4F);
    EXPECT_EQ(layers.sheenColor, glm::vec3(0.3F, 0.4F, 0.5F));
    EXPECT_EQ(layers.sheenRoughness, 0.6F);
    EXPECT_EQ(layers.anisotropy, 0.8F);
    EXPECT_EQ(layers.anisotropyRotation, 1.0F);
    EXPECT_EQ(layers.transmission, 0.9F);
    for (const auto* texture :
         {&layers.specularTexture, &layers.specularColorTexture, &layers.clearcoatTexture,
          &layers.clearcoatRoughnessTexture, &layers.clearcoatNormalTexture,
          &layers.sheenColorTexture, &layers.sheenRoughnessTexture, &layers.anisotropyTexture,
          &layers.transmissionTexture}) {
        EXPECT_TRUE(texture->has_value());
    }
    EXPECT_TRUE(loaded.scene.materials[0].isSeeThrough());
    // Anisotropy needs tangents, which the file lacks.
    EXPECT_EQ(onlyPrimitive(loaded).tangents.size(), 3U);
    expectLine(loaded, Report::Kind::kIgnored, "/materials/0/extensions/KHR_materials_transmission",
               "thin clear wall");
}

TEST(LayersTest, GlossinessIsAPerfectBoundaryOfTheSpecularColour) {
    const LoadedScene loaded =
        load(layeredFile({{"KHR_materials_pbrSpecularGlossiness",
                           {{"diffuseFactor", {0.1, 0.2, 0.3, 0.4}},
                            {"specularFactor", {0.5, 0.6, 0.7}},
                            {"glossinessFactor", 0.75},
                            {"specularGlossinessTexture", {{"index", 0}}}}}}));
    EXPECT_EQ(reportText(loaded), "");
    const Material& material = loaded.scene.materials.at(0);
    EXPECT_EQ(material.baseColor, glm::vec4(0.1F, 0.2F, 0.3F, 0.4F));
    EXPECT_EQ(material.metallic, 0.0F);
    EXPECT_EQ(material.roughness, 0.25F);
    ASSERT_TRUE(material.layers);
    EXPECT_EQ(material.layers->ior, 0.0F);
    EXPECT_EQ(material.layers->specularColor, glm::vec3(0.5F, 0.6F, 0.7F));
    EXPECT_TRUE(material.layers->glossinessInSpecular);
}

TEST(LayersTest, UnlitSurfacesHaveNone) {
    const LoadedScene loaded =
        load(layeredFile({{"KHR_materials_unlit", json::object()},
                          {"KHR_materials_clearcoat", {{"clearcoatFactor", 1.0}}}}));
    EXPECT_FALSE(layersOf(loaded).has_value());
}

TEST(LayersTest, ValuesOutOfRangeAreMended) {
    const auto mended = [](const json& extensions, const std::string& pointer) {
        const LoadedScene loaded = load(layeredFile(extensions));
        expectLine(loaded, Report::Kind::kRepaired, "/materials/0/extensions/" + pointer, "");
        return layersOf(loaded).value_or(MaterialLayers{});
    };
    EXPECT_EQ(mended({{"KHR_materials_clearcoat", {{"clearcoatFactor", 3.0}}}},
                     "KHR_materials_clearcoat/clearcoatFactor")
                  .clearcoat,
              1.0F);
    EXPECT_EQ(mended({{"KHR_materials_ior", {{"ior", 0.4}}}}, "KHR_materials_ior/ior").ior, 1.0F);
    EXPECT_EQ(mended({{"KHR_materials_sheen", {{"sheenColorFactor", "red"}}}},
                     "KHR_materials_sheen/sheenColorFactor")
                  .sheenColor,
              glm::vec3(0.0F));
}

TEST(LayersTest, OtherExtensionsOfMaterialsAreSaid) {
    for (const char* name : {"KHR_materials_dispersion", "KHR_materials_iridescence",
                             "KHR_materials_volume", "KHR_materials_diffuse_transmission"}) {
        expectLine(load(layeredFile({{name, json::object()}})), Report::Kind::kIgnored,
                   std::string("/materials/0/extensions/") + name, "not supported");
    }
}

}  // namespace
}  // namespace ribalta::test
