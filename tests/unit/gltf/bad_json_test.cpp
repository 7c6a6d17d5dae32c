// One broken document for each rule: refused at its place, or drawn without what is broken.
#include <gtest/gtest.h>

#include "gltf_file.h"

namespace ribalta::test {
namespace {

using nlohmann::json;

// A document with one of everything that has structure, so that each can be broken.
GltfFile fullFile() {
    GltfFile file = triangleFile();
    file.json["meshes"][0]["primitives"][0]["indices"] =
        file.addAccessor(std::vector<std::uint16_t>{0, 1, 2}, "SCALAR", 5123, 3);
    file.push("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}});
    file.addNode({{"camera", 0}});
    file.push("materials", json::object());
    file.push("nodes", json::object());
    file.json["nodes"][0]["children"] = {2};
    return file;
}

struct Break {
    const char* at;       // what is replaced
    json by;              // null: removed
    const char* pointer;  // where the error stands
    const char* word;
};

TEST(BadJsonTest, StructureIsRefusedAtItsPlace) {
    const Break breaks[] = {
        {"/asset", nullptr, "/asset", "version"},
        {"/asset/version", nullptr, "/asset", "version"},
        {"/asset/version", 2.0, "/asset", "version"},
        {"/asset/version", "1.0", "/asset/version", "glTF 2"},
        {"/asset/version", "3.0", "/asset/version", "glTF 2"},
        {"/asset/version", "two", "/asset/version", "2.0"},
        {"/asset/minVersion", "2.1", "/asset/minVersion", "reads glTF 2.0"},
        {"/extensionsRequired", json{"VENDOR_magic"}, "/extensionsRequired/0", "VENDOR_magic"},
        {"/extensionsRequired", json{3}, "/extensionsRequired/0", "name"},
        {"/meshes", json::object(), "/meshes", "array of objects"},
        {"/meshes/0", 3, "/meshes/0", "expected an object"},
        {"/meshes/0/primitives", nullptr, "/meshes/0", "primitives"},
        {"/meshes/0/primitives/0/attributes", nullptr, "/meshes/0/primitives/0", "attributes"},
        {"/meshes/0/primitives/0/attributes/POSITION", 9,
         "/meshes/0/primitives/0/attributes/POSITION", "2 accessors"},
        {"/meshes/0/primitives/0/attributes/POSITION", "0",
         "/meshes/0/primitives/0/attributes/POSITION", "index"},
        {"/meshes/0/primitives/0/indices", -1, "/meshes/0/primitives/0/indices", "2 accessors"},
        {"/meshes/0/primitives/0/mode", 7, "/meshes/0/primitives/0/mode", "is 7"},
        {"/accessors/0/componentType", 5124, "/accessors/0/componentType", "5124"},
        {"/accessors/0/componentType", 5130, "/accessors/0/componentType", "5130"},
        {"/accessors/0/type", "VEC5", "/accessors/0/type", "VEC3"},
        {"/accessors/0/count", 0, "/accessors/0/count", "at least 1"},
        {"/accessors/0/count", -4, "/accessors/0/count", "at least 1"},
        {"/accessors/0/count", 2.5, "/accessors/0/count", "integer"},
        {"/accessors/0/count", nullptr, "/accessors/0", "count"},
        {"/accessors/0/bufferView", 77, "/accessors/0/bufferView", "2 bufferViews"},
        {"/accessors/0/byteOffset", -4, "/accessors/0/byteOffset", "at least 0"},
        {"/accessors/0/sparse", json{{"count", 1}}, "/accessors/0/sparse", "indices"},
        {"/bufferViews/0/buffer", 1, "/bufferViews/0/buffer", "1 buffer"},
        {"/bufferViews/0/byteLength", 0, "/bufferViews/0/byteLength", "at least 1"},
        {"/bufferViews/0/byteStride", 2, "/bufferViews/0/byteStride", "4 to 252"},
        {"/bufferViews/0/byteStride", 13, "/bufferViews/0/byteStride", "multiple of 4"},
        {"/bufferViews/0/byteStride", 256, "/bufferViews/0/byteStride", "4 to 252"},
        {"/nodes/0/children", json{55}, "/nodes/0/children/0", "3 nodes"},
        {"/nodes/0/mesh", 1, "/nodes/0/mesh", "1 mesh"},
        {"/nodes/1/camera", 1, "/nodes/1/camera", "1 camera"},
        {"/nodes/0/matrix", json{1, 2, 3}, "/nodes/0/matrix", "expected 16"},
        {"/nodes/0/translation", json{1, 2, "3"}, "/nodes/0/translation/2", "number"},
        {"/nodes/0/rotation", json{0, 0, 1}, "/nodes/0/rotation", "expected 4"},
        {"/scenes/0/nodes", json{12}, "/scenes/0/nodes/0", "3 nodes"},
        {"/cameras/0/type", "fisheye", "/cameras/0/type", "perspective"},
    };
    for (const Break& broken : breaks) {
        SCOPED_TRACE(std::string(broken.at) + " = " + broken.by.dump());
        GltfFile file = fullFile();
        // The buffer is put in only when the file is written; indices into it need it here.
        file.json["buffers"] = json::array({{{"byteLength", file.bytes().size()},
                                             {"uri", "data:;base64," + base64(file.bytes())}}});
        const json::json_pointer at(broken.at);
        if (broken.by.is_null()) {
            file.json.at(at.parent_pointer()).erase(at.back());
        } else {
            file.json[at] = broken.by;
        }
        expectRefused(file, broken.pointer, {broken.word});
    }
}

TEST(BadJsonTest, ValuesAreMendedAndTold) {
    const Break breaks[] = {
        {"/scene", 5, "/scene", "1 scene"},
        {"/nodes/0/name", 3, "/nodes/0/name", "string"},
        {"/meshes/0/primitives/0/material", 5, "/meshes/0/primitives/0/material", "1 material"},
        {"/accessors/0/normalized", "no", "/accessors/0/normalized", "true or false"},
        {"/extensionsUsed", "all", "/extensionsUsed", "array of strings"},
        {"/nodes/0/extensions", json::array(), "/nodes/0/extensions", "object"},
        {"/materials/0/doubleSided", 1, "/materials/0/doubleSided", "true or false"},
        {"/extensions", json{{"KHR_lights_punctual", 3}}, "/extensions/KHR_lights_punctual",
         "list of lights"},
    };
    for (const Break& broken : breaks) {
        SCOPED_TRACE(std::string(broken.at) + " = " + broken.by.dump());
        GltfFile file = fullFile();
        file.json[json::json_pointer(broken.at)] = broken.by;
        const LoadedScene loaded = load(file);
        EXPECT_EQ(loaded.scene.meshes.size(), 1U);
        expectLine(loaded, Report::Kind::kRepaired, broken.pointer, broken.word);
    }
}

TEST(BadJsonTest, IntegersMayBeWrittenAsFloats) {
    GltfFile file = fullFile();
    file.json["accessors"][0]["count"] = 3.0;
    file.json["nodes"][0]["mesh"] = 0.0;
    EXPECT_EQ(reportText(load(file)), "");
}

// A fault in a buffer costs the primitive that uses it; with no other left, it is the file's.
TEST(BadJsonTest, DataThatDoesNotFitCostsItsPrimitive) {
    const Break breaks[] = {
        {"/accessors/0/count", 4, "/accessors/0", "needs 4 elements"},
        {"/accessors/0/count", 4000000000000000000ULL, "/accessors/0", "needs 4000000000000000000"},
        {"/accessors/0/byteOffset", 4000000000ULL, "/accessors/0", "its buffer view has 36 bytes"},
        {"/accessors/0/type", "VEC4", "/accessors/0/type", "is not VEC3"},
        {"/bufferViews/0/byteLength", 35, "/accessors/0", "has 35 bytes"},
        {"/bufferViews/0/byteLength", 1000, "/bufferViews/0", "ends at byte 0 + 1000"},
        {"/bufferViews/0/byteOffset", 1ULL << 40U, "/bufferViews/0", "ends at byte"},
        {"/bufferViews/0/byteStride", 252, "/accessors/0", "252 apart"},
        {"/bufferViews/0/byteStride", 4, "/accessors/0", "stride of 4"},
        {"/accessors/1/componentType", 5126, "/accessors/1", "unsigned integer"},
        {"/accessors/1/componentType", 5125, "/accessors/1", "needs 3 elements of 4 bytes"},
    };
    for (const Break& broken : breaks) {
        SCOPED_TRACE(std::string(broken.at) + " = " + broken.by.dump());
        GltfFile file = fullFile();
        file.json[json::json_pointer(broken.at)] = broken.by;
        expectRefused(file, broken.pointer, {broken.word});
        file.addMesh(
            {{"attributes", {{"POSITION", file.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0})}}}});
        const LoadedScene loaded = load(file);
        expectLine(loaded, Report::Kind::kIgnored, broken.pointer, "primitive 0 of mesh 0");
        EXPECT_TRUE(loaded.scene.meshes.at(0).primitives.empty());
        EXPECT_EQ(loaded.scene.meshes.at(1).primitives.size(), 1U);
    }
}

TEST(BadJsonTest, IndexOutOfRangeCostsItsPrimitive) {
    GltfFile file = triangleFile();
    file.json["meshes"][0]["primitives"][0]["indices"] =
        file.addAccessor(std::vector<std::uint16_t>{0, 1, 3}, "SCALAR", 5123, 3);
    expectRefused(file, "/meshes/0/primitives/0/indices", {"element 2 is 3", "3 vertices"});
}

TEST(BadJsonTest, SparseThatDoesNotFitIsRefused) {
    const auto sparseFile = [](std::uint16_t index, int count) {
        GltfFile file = triangleFile();
        file.json["accessors"][0]["sparse"] = {
            {"count", count},
            {"indices",
             {{"bufferView", file.addView(std::vector<std::uint16_t>{index})},
              {"componentType", 5123}}},
            {"values", {{"bufferView", file.addView(std::vector<float>{1, 1, 1})}}}};
        return file;
    };
    EXPECT_NO_THROW(load(sparseFile(2, 1)));
    expectRefused(sparseFile(3, 1), "/accessors/0/sparse/indices", {"element 0 is 3"});
    expectRefused(sparseFile(0, 2), "/accessors/0/sparse/indices", {"needs 2 elements"});
    expectRefused(sparseFile(0, 4), "/accessors/0/sparse/count", {"only 3 elements"});
}

TEST(BadJsonTest, AccessorsWithoutDataHaveALimit) {
    GltfFile file;
    const int accessor = file.push(
        "accessors", {{"componentType", 5126}, {"type", "VEC3"}, {"count", 1000000000000ULL}});
    file.addMesh({{"attributes", {{"POSITION", accessor}}}});
    expectRefused(file, "/accessors/0", {"no data", "4194304"});
}

}  // namespace
}  // namespace ribalta::test
