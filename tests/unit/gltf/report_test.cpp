// What is in a file and not drawn, and the lists of extensions.
#include <gtest/gtest.h>

#include "gltf_file.h"

namespace ribalta::test {
namespace {

using nlohmann::json;

TEST(GltfReportTest, CleanFileHasNothingToTell) {
    const LoadedScene loaded = load(triangleFile());
    EXPECT_EQ(reportText(loaded), "");
    EXPECT_TRUE(loaded.extensionsUsed.empty());
    ASSERT_FALSE(loaded.stages.empty());
    for (const LoadedScene::Stage& stage : loaded.stages) {
        EXPECT_GE(stage.ms, 0.0) << stage.name;
    }
}

TEST(GltfReportTest, FeaturesThatAreNotDrawn) {
    GltfFile file = triangleFile();
    json& primitive = file.json["meshes"][0]["primitives"][0];
    primitive["targets"] = json::array({{{"TEXCOORD_0", 0}}});
    for (const char* name : {"TEXCOORD_2", "COLOR_1", "_HEAT", "JOINTS_0"}) {
        primitive["attributes"][name] = 0;
    }
    const LoadedScene loaded = load(file);
    const Report::Kind ignored = Report::Kind::kIgnored;
    const std::string attributes = "/meshes/0/primitives/0/attributes/";
    expectLine(loaded, ignored, "/meshes/0/primitives/0/targets/0/TEXCOORD_0", "not morphed");
    expectLine(loaded, ignored, attributes + "TEXCOORD_2", "TEXCOORD_2");
    expectLine(loaded, ignored, attributes + "COLOR_1", "COLOR_1");
    expectLine(loaded, ignored, attributes + "_HEAT", "_HEAT");
}

TEST(GltfReportTest, ExtensionsAreToldOnceEach) {
    GltfFile file = triangleFile();
    file.json["extensionsUsed"] = {"KHR_materials_iridescence", "KHR_materials_unlit",
                                   "EXT_unheard_of"};
    for (int i = 0; i < 3; ++i) {
        file.push("materials", {{"extensions",
                                 {{"KHR_materials_iridescence", json::object()},
                                  {"KHR_materials_unlit", json::object()}}}});
    }
    file.json["nodes"][0]["extensions"]["EXT_unheard_of"] = {{"lightProfile", 0}};
    // What users keep in extras is theirs.
    file.json["nodes"][0]["extras"]["extensions"]["VENDOR_private"] = json::object();
    const LoadedScene loaded = load(file);
    EXPECT_EQ(loaded.extensionsUsed.size(), 3U);
    EXPECT_EQ(loaded.extensionsIgnored,
              (std::vector<std::string>{"KHR_materials_iridescence", "EXT_unheard_of"}));
    EXPECT_EQ(loaded.report.entries().size(), 2U) << reportText(loaded);
    expectLine(loaded, Report::Kind::kIgnored, "/materials/0/extensions/KHR_materials_iridescence",
               "3 places");
    expectLine(loaded, Report::Kind::kIgnored, "/nodes/0/extensions/EXT_unheard_of",
               "EXT_unheard_of");
}

TEST(GltfReportTest, ExtensionsThatAreNotDeclaredAreHints) {
    GltfFile file = triangleFile();
    file.push("materials", {{"extensions", {{"KHR_materials_unlit", json::object()}}}});
    file.json["extensionsRequired"] = {"KHR_texture_transform"};
    const LoadedScene loaded = load(file);
    EXPECT_EQ(loaded.report.entries().size(), 2U) << reportText(loaded);
    expectLine(loaded, Report::Kind::kHint, "/materials/0/extensions/KHR_materials_unlit",
               "missing in extensionsUsed");
    expectLine(loaded, Report::Kind::kHint, "/extensionsRequired", "KHR_texture_transform");
}

TEST(GltfReportTest, NormalsThatAreNotOfUnitLength) {
    GltfFile file = triangleFile();
    const std::vector<glm::vec3> normals = {{0, 1, 0}, {0, 1.01F, 0}, {1, 1, 0}};
    file.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
        file.addAccessor(normals, "VEC3", kFloat, 3);
    const LoadedScene loaded = load(file);
    expectLine(loaded, Report::Kind::kRepaired, "/meshes/0/primitives/0/attributes/NORMAL",
               "1 normal not of unit");
    for (const glm::vec3& normal : loaded.scene.meshes.at(0).primitives.at(0).normals) {
        EXPECT_NEAR(glm::length(normal), 1.0F, 1e-6F);
    }
}

TEST(GltfReportTest, UnknownCompressionWithFallbackDataIsDrawnFromIt) {
    GltfFile file = triangleFile();
    file.json["extensionsUsed"] = {"KHR_meshopt_compression"};
    file.json["bufferViews"][0]["extensions"]["KHR_meshopt_compression"] = {{"buffer", 0}};
    const LoadedScene loaded = load(file);
    EXPECT_EQ(onlyPrimitive(loaded).positions.size(), 3U);
    expectLine(loaded, Report::Kind::kIgnored, "/bufferViews/0/extensions/KHR_meshopt_compression",
               "not supported");
}

TEST(GltfReportTest, BufferWithoutDataCostsItsPrimitives) {
    GltfFile file = triangleFile();
    file.json["buffers"] = json::array({{{"byteLength", 36}}});
    const LoadedScene loaded = load(file);
    EXPECT_TRUE(loaded.scene.meshes.at(0).primitives.empty());
    expectLine(loaded, Report::Kind::kIgnored, "/meshes/0/primitives/0", "no data");
}

TEST(GltfReportTest, NothingToDrawIsAHint) {
    const GltfFile file;
    expectLine(load(file), Report::Kind::kHint, "", "nothing to draw");
}

TEST(GltfReportTest, UnusedDataThatDoesNotFitIsAHint) {
    GltfFile file = triangleFile();
    file.addPositions({0, 0, 0});
    file.json["accessors"][1]["count"] = 5;
    file.push("bufferViews", {{"buffer", 0}, {"byteLength", 99999}});
    const LoadedScene loaded = load(file);
    expectLine(loaded, Report::Kind::kHint, "/accessors/1", "reaches past its buffer view");
    expectLine(loaded, Report::Kind::kHint, "/bufferViews/2", "reaches past its buffer");
}

TEST(GltfReportTest, MisalignedDataIsAHint) {
    GltfFile file;
    const std::vector<std::uint8_t> bytes(41, 0);
    const int view = file.addView(bytes);
    file.push("accessors", {{"bufferView", view},
                            {"byteOffset", 1},
                            {"componentType", 5126},
                            {"type", "VEC3"},
                            {"count", 3}});
    file.addMesh({{"attributes", {{"POSITION", 0}}}, {"mode", 0}});
    expectLine(load(file), Report::Kind::kHint, "/accessors/0", "not aligned");
}

}  // namespace
}  // namespace ribalta::test
