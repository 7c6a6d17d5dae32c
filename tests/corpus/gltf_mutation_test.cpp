// Files broken by the hundred: whatever is changed, a file is refused at a place or makes a scene
// that keeps its promises.
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "support/make_png.h"
#include "support/scene_faults.h"
#include "unit/gltf/gltf_file.h"

namespace ribalta::test {
namespace {

using nlohmann::json;

void expectSceneOrPlace(const std::filesystem::path& path) {
    try {
        const LoadedScene loaded = loadGltf(path);
        for (const std::string& fault : sceneFaults(loaded.scene)) {
            ADD_FAILURE() << fault;
        }
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
        EXPECT_EQ(error.place().file, path.string()) << error.what();
    }
}

// One of everything that the import reads.
GltfFile fullFile() {
    GltfFile file = triangleFile();
    json& primitive = file.json["meshes"][0]["primitives"][0];
    primitive["mode"] = 4;
    primitive["material"] = 0;
    primitive["indices"] = file.addAccessor(std::vector<std::uint16_t>{0, 1, 2}, "SCALAR", 5123, 3);
    primitive["attributes"]["TEXCOORD_0"] =
        file.addAccessor(std::vector<float>{0, 0, 1, 0, 0, 1}, "VEC2", 5126, 3);
    file.json["bufferViews"][0]["byteStride"] = 12;
    file.json["accessors"][0].update(
        {{"byteOffset", 0},
         {"normalized", false},
         {"sparse",
          {{"count", 1},
           {"indices",
            {{"bufferView", file.addView(std::vector<std::uint16_t>{1})},
             {"byteOffset", 0},
             {"componentType", 5123}}},
           {"values",
            {{"bufferView", file.addView(std::vector<float>{1, 1, 1})}, {"byteOffset", 0}}}}}});
    file.push("images", {{"bufferView", file.addView(makePng({.rows = {std::string(4, '\xff')}}))},
                         {"mimeType", "image/png"}});
    file.push("samplers", {{"magFilter", 9729}, {"minFilter", 9987}, {"wrapS", 10497}});
    file.push("textures", {{"source", 0}, {"sampler", 0}});
    const json slot = {
        {"index", 0},
        {"texCoord", 0},
        {"extensions", {{"KHR_texture_transform", {{"offset", {0, 0}}, {"rotation", 1.0}}}}}};
    file.push(
        "materials",
        {{"name", "paint"},
         {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 1}}, {"baseColorTexture", slot}}},
         {"normalTexture", slot},
         {"alphaMode", "MASK"},
         {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 2}}}}}});
    file.push("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}});
    file.json["extensions"]["KHR_lights_punctual"]["lights"] =
        json::array({{{"type", "spot"},
                      {"color", {1, 1, 1}},
                      {"range", 5},
                      {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.2}}},
                      {"extras", {{"light_map", {{"texture", 0}}}, {"light_map_rotation", 45}}}}});
    file.json["nodes"][0]["children"] = {1};
    file.push("nodes", {{"camera", 0},
                        {"rotation", {0, 0, 0, 1}},
                        {"scale", {1, 1, 1}},
                        {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    const int times = file.addAccessor(std::vector<float>{0, 1}, "SCALAR", 5126, 2);
    const int turns = file.addAccessor(std::vector<std::int16_t>{0, 0, 0, 32767, 0, 0, 32767, 0},
                                       "VEC4", 5122, 2);
    file.json["accessors"][std::size_t(turns)]["normalized"] = true;
    const json sampler = {{"input", times}, {"output", turns}, {"interpolation", "LINEAR"}};
    const json channel = {{"sampler", 0}, {"target", {{"node", 1}, {"path", "rotation"}}}};
    json samplers = json::array({sampler});
    json channels = json::array({channel});
    const auto point = [&](const char* pointer, int output) {
        channels.push_back(
            {{"sampler", samplers.size()},
             {"target",
              {{"path", "pointer"},
               {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}}}});
        samplers.push_back({{"input", times}, {"output", output}, {"interpolation", "STEP"}});
    };
    const int numbers = file.addAccessor(std::vector<float>{0.5F, 2}, "SCALAR", 5126, 2);
    point("/extensions/KHR_lights_punctual/lights/0/spot/outerConeAngle", numbers);
    point("/cameras/0/perspective/znear", numbers);
    point("/nodes/1/extensions/KHR_node_visibility/visible",
          file.addAccessor(std::vector<std::uint8_t>{1, 0}, "SCALAR", 5121, 2));
    point("/materials/0/pbrMetallicRoughness/baseColorFactor",
          file.addAccessor(std::vector<float>{0, 0, 0, 1, 1, 1, 1, 0}, "VEC4", 5126, 2));
    file.push("animations", {{"name", "turn"}, {"samplers", samplers}, {"channels", channels}});
    json coefficients = json::array();
    for (int i = 0; i < 9; ++i) {
        coefficients.push_back({1, 2, 3});
    }
    file.json["extensions"]["EXT_lights_image_based"]["lights"] =
        json::array({{{"intensity", 2},
                      {"rotation", {0, 0, 0, 1}},
                      {"irradianceCoefficients", coefficients},
                      {"specularImages", json::array({json::array({0, 0, 0, 0, 0, 0})})}}});
    file.json["scenes"][0]["extensions"]["EXT_lights_image_based"]["light"] = 0;
    file.json["extensionsUsed"] = {"KHR_lights_punctual", "KHR_animation_pointer",
                                   "EXT_lights_image_based"};
    file.json["buffers"] = json::array(
        {{{"byteLength", file.bytes().size()}, {"uri", "data:;base64," + base64(file.bytes())}}});
    return file;
}

TEST(MutationTest, EveryMemberByEveryOddValue) {
    const json oddValues[] = {nullptr,
                              -1,
                              0,
                              1,
                              3,
                              255,
                              5121,
                              2147483648LL,
                              -2147483649LL,
                              18446744073709551615ULL,
                              0.5,
                              1e308,
                              -1e-308,
                              "",
                              "../x",
                              true,
                              json::array(),
                              json::object(),
                              json{0, 0, 0}};
    const TestFolder folder;
    const json original = fullFile().json;
    ASSERT_NO_THROW(load(folder.write("whole.gltf", original.dump())));
    // Every leaf, and all that it lies in.
    std::set<std::string> pointers;
    const json leaves = original.flatten();
    for (const auto& [pointer, value] : leaves.items()) {
        for (json::json_pointer at(pointer); !at.empty(); at.pop_back()) {
            pointers.insert(at.to_string());
        }
    }
    for (const std::string& pointer : pointers) {
        for (const json& odd : oddValues) {
            SCOPED_TRACE(pointer + " = " + odd.dump());
            json changed = original;
            changed[json::json_pointer(pointer)] = odd;
            expectSceneOrPlace(folder.write("changed.gltf", changed.dump()));
        }
    }
}

TEST(MutationTest, DamagedDracoData) {
    const auto sample = std::filesystem::path(RIBALTA_SOURCE_DIR) / "samples/scenes/arena.glb";
    std::ifstream stream(sample, std::ios::binary);
    const std::string original((std::istreambuf_iterator<char>(stream)), {});
    ASSERT_GT(original.size(), 100000U);
    const auto* bytes = reinterpret_cast<const unsigned char*>(original.data());
    const std::size_t jsonLength = bytes[12] + (bytes[13] << 8U) + (bytes[14] << 16U);
    const TestFolder folder;
    std::mt19937 random(1);  // NOLINT(cert-msc51-cpp): the same files in every run
    for (int run = 0; run < 100; ++run) {
        SCOPED_TRACE(run);
        std::string changed = original;
        for (int i = 0; i < 20; ++i) {
            changed[20 + jsonLength + 8 + random() % 20000] = char(random() & 0xFFU);
        }
        expectSceneOrPlace(folder.write("changed.glb", changed));
    }
}

}  // namespace
}  // namespace ribalta::test
