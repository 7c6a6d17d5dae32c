// KHR_materials_variants: which material a primitive has.
#include <gtest/gtest.h>

#include "gltf_file.h"
#include "support/expect_error.h"

namespace ribalta::test {
namespace {

using nlohmann::json;

constexpr const char* kVariants = "KHR_materials_variants";

// Materials of green 0, 0.1, 0.2; variants "day" and "night".
GltfFile variantFile() {
    GltfFile file = triangleFile();
    for (const double green : {0.0, 0.1, 0.2}) {
        file.push("materials",
                  {{"pbrMetallicRoughness", {{"baseColorFactor", {0.5, green, 0.5, 1.0}}}}});
    }
    file.json["extensionsUsed"] = {kVariants};
    file.json["extensions"][kVariants]["variants"] = {{{"name", "day"}}, {{"name", "night"}}};
    json& primitive = file.json["meshes"][0]["primitives"][0];
    primitive["material"] = 0;
    primitive["extensions"][kVariants]["mappings"] = {{{"material", 1}, {"variants", {0}}},
                                                      {{"material", 2}, {"variants", {1}}}};
    return file;
}

LoadedScene loadVariant(const GltfFile& file, const std::optional<std::string>& variant) {
    const TestFolder folder;
    LoadOptions options;
    options.variant = variant;
    return loadGltf(file.writeTo(folder), options);
}

// The green of the only material that is left: others are not read.
double greenOf(const LoadedScene& loaded) {
    EXPECT_EQ(loaded.scene.materials.size(), 1U);
    return double(
        loaded.scene.materials.at(std::size_t(onlyPrimitive(loaded).material)).baseColor.y);
}

TEST(VariantsTest, TheChosenOneHasItsMaterials) {
    const GltfFile file = variantFile();
    EXPECT_NEAR(greenOf(loadVariant(file, std::nullopt)), 0.0, 1e-6);
    EXPECT_NEAR(greenOf(loadVariant(file, "day")), 0.1, 1e-6);
    EXPECT_NEAR(greenOf(loadVariant(file, "night")), 0.2, 1e-6);
    EXPECT_NEAR(greenOf(loadVariant(file, "1")), 0.2, 1e-6);
    const LoadedScene loaded = load(file);
    EXPECT_EQ(reportText(loaded), "");
    EXPECT_EQ(loaded.variantNames, (std::vector<std::string>{"day", "night"}));
}

TEST(VariantsTest, AnUnknownOneIsRefusedWithAListOfThoseThereAre) {
    expectError(ErrorKind::kUsage, {"no variant 'dusk'", "0 day, 1 night"},
                [] { loadVariant(variantFile(), "dusk"); });
    expectError(ErrorKind::kUsage, {"no variant 'dusk'", "none at all"},
                [] { loadVariant(triangleFile(), "dusk"); });
}

TEST(VariantsTest, BrokenMappingsAreLeftOut) {
    const std::string pointer = "/meshes/0/primitives/0/extensions/KHR_materials_variants/mappings";
    const auto said = [&](const json& mappings, const std::string& at, const std::string& word,
                          double green) {
        GltfFile file = variantFile();
        file.json["meshes"][0]["primitives"][0]["extensions"][kVariants]["mappings"] = mappings;
        const LoadedScene loaded = loadVariant(file, "night");
        expectLine(loaded, Report::Kind::kIgnored, at, word);
        EXPECT_NEAR(greenOf(loaded), green, 1e-6);
    };
    said({{{"material", 9}, {"variants", {1}}}}, pointer + "/0/material", "is 9", 0.0);
    said({{{"material", 2}, {"variants", {7, 1}}}}, pointer + "/0/variants/0", "is 7", 0.2);
    said({{{"material", 2}}}, pointer + "/0", "no list of variants", 0.0);
    said({7, {{"material", 2}, {"variants", {1}}}}, pointer + "/0", "no object", 0.2);
    said({{{"material", 2}, {"variants", {1}}}, {{"material", 1}, {"variants", {1}}}},
         pointer + "/1/variants/0", "again", 0.2);
    said("all", pointer.substr(0, pointer.rfind('/')), "no list of mappings", 0.0);
}

}  // namespace
}  // namespace ribalta::test
