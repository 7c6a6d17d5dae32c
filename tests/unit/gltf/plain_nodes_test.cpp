// Nodes that are read without a tree, against the same ones read from it: after a byte order mark a
// document is parsed by the other parser, which makes trees of all.
#include <random>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "gltf_file.h"

namespace ribalta::test {
namespace {

// What loading says, in text: the nodes and the report, or the error.
std::string outcomeOf(const std::filesystem::path& path) {
    try {
        const LoadedScene loaded = loadGltf(path);
        std::ostringstream outcome;
        outcome.precision(17);
        for (const Node& node : loaded.scene.nodes) {
            outcome << "node " << node.name << ' ' << node.parent << ' ' << node.mesh << ' '
                    << node.shown << ' ' << node.deformer;
            for (int i = 0; i < 16; ++i) {
                outcome << ' ' << node.worldFromLocal[i / 4][i % 4];
            }
            outcome << '\n';
        }
        for (const Camera& camera : loaded.scene.cameras) {
            outcome << "camera " << camera.name << ' ' << camera.node << '\n';
        }
        for (const Report::Entry& entry : loaded.report.entries()) {
            outcome << entry.place.text() << ' ' << entry.message << '\n';
        }
        return outcome.str();
    } catch (const Error& error) {
        return error.what();
    }
}

class PlainNodesTest : public testing::Test {
  protected:
    // Fails where the two ways of reading differ. Returns what came of it.
    std::string expectSame(const std::string& text) {
        std::string outcome = outcomeOf(folder_.write("nodes.gltf", text));
        const std::string other = outcomeOf(folder_.write("nodes.gltf", "\xef\xbb\xbf" + text));
        EXPECT_EQ(outcome, other) << text;
        return outcome;
    }

    // The same with these members of a node, written as they stand, before another node.
    std::string expectSameNode(const std::string& members) {
        GltfFile file = triangleFile();
        file.json["nodes"] = {"MEMBERS", {{"mesh", 0}, {"name", "last"}}};
        file.json["scenes"][0]["nodes"] = {0, 1};
        file.json["cameras"] = {
            {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}}};
        std::string text = file.text();
        const std::string mark = "\"MEMBERS\"";
        text.replace(text.find(mark), mark.size(), members);
        return expectSame(text);
    }

  private:
    TestFolder folder_;
};

TEST_F(PlainNodesTest, OneOddMemberIsReadAsFromTheTree) {
    for (const char* members : {
             R"({})",
             R"({"name":"x","mesh":0,"translation":[1,2.5,-3],"rotation":[0,0,0.6,0.8]})",
             R"({"scale":[1,2,18446744073709551615],"camera":0,"children":[1]})",
             R"({"matrix":[2,0,0,0,0,2,0,0,0,0,2,0,1,2,3,1],"extras":{"a":[{"extensions":{}}]}})",
             R"({"name":"","extras":7})",
             R"({"name":7})",
             R"({"name":"a\nb\u0000c"})",
             R"({"name":"first","name":"then","mesh":9,"mesh":0})",
             R"({"name":7,"name":"then"})",
             R"({"mesh":1})",
             R"({"mesh":-1})",
             R"({"mesh":0.0})",
             R"({"mesh":0.5})",
             R"({"mesh":"0"})",
             R"({"mesh":18446744073709551615})",
             R"({"camera":1})",
             R"({"camera":null})",
             R"({"children":[]})",
             R"({"children":[0]})",
             R"({"children":[2]})",
             R"({"children":[1,1]})",
             R"({"children":[1.0]})",
             R"({"children":1})",
             R"({"children":[true]})",
             R"({"translation":[1,2]})",
             R"({"translation":[1,2,3,4]})",
             R"({"translation":[1,2,"3"]})",
             R"({"translation":[1,2,1e300]})",
             R"({"rotation":[0,0,0,0]})",
             R"({"rotation":[0,0,0,2]})",
             R"({"rotation":{}})",
             R"({"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0]})",
             R"({"matrix":[1,0,0,1,0,1,0,0,0,0,1,0,0,0,0,1]})",
             R"({"weights":[1]})",
             R"({"skin":0})",
             R"({"mesh":0,"weights":[1]})",
             R"({"extensions":{"KHR_node_visibility":{"visible":false}}})",
             R"({"extensions":{"UNHEARD_OF":{}}})",
             R"({"extensions":7})",
             R"({"unheardOf":{"extensions":{"UNHEARD_OF":{}}}})",
             R"({"extensions":{"KHR_node_visibility":{"visible":false}},"name":"x","mesh":0})",
             R"({"extensions":{"KHR_node_visibility":{"visible":7}},"translation":[1,2,3]})",
             R"({"name":7,"extensions":{"KHR_node_visibility":{"visible":false}}})",
             R"({"mesh":0,"skin":0,"weights":[1],"name":"x","extras":{},"unheardOf":[1]})",
             R"({"skin":7,"name":"a","scale":[1,1,1],"name":"b"})",
             R"(null)",
             R"(7)",
             R"([])",
         }) {
        expectSameNode(members);
    }
    EXPECT_NE(expectSameNode(R"({"name":"first","name":"then"})").find("node then "),
              std::string::npos);
}

TEST_F(PlainNodesTest, ArraysThatStandTwiceAreReadAsFromTheTree) {
    const std::string start = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],)";
    for (const char* rest : {
             R"("nodes":[{"name":"a"},{"name":"b"}],"nodes":[{"name":"c"}]})",
             R"("nodes":[{"name":"a","camera":0}],"cameras":[7],"cameras":[]})",
             R"("nodes":{},"nodes":[{"name":"c"}]})",
             R"("nodes":[{"name":"c"}],"nodes":{}})",
             R"("nodes":7})",
             R"("nodes":[]})",
             R"("cameras":[]})",
         }) {
        expectSame(start + rest);
    }
}

TEST_F(PlainNodesTest, ForestsAreReadAsFromTheTree) {
    std::mt19937 random(5);
    for (int round = 0; round < 200; ++round) {
        GltfFile file = triangleFile();
        const int count = 2 + int(random() % 12);
        file.json["nodes"] = nlohmann::json::array();
        file.json["scenes"][0]["nodes"] = {0};
        for (int i = 0; i < count; ++i) {
            nlohmann::json node = {{"name", "node " + std::to_string(i)}};
            if (random() % 2 == 0) {
                node["mesh"] = 0;
            }
            if (random() % 2 == 0) {
                node["translation"] = {int(random() % 9), 0.25, -1e-3};
            }
            if (random() % 3 == 0) {
                node["extensions"]["KHR_node_visibility"]["visible"] = random() % 2 == 0;
            }
            for (int child = i + 1; child < count && random() % 3 != 0; ++child) {
                node["children"].push_back(child);
            }
            file.json["nodes"].push_back(node);
        }
        if (random() % 8 == 0) {
            file.json["nodes"][std::size_t(count - 1)]["children"].push_back(int(random() % 2));
        }
        if (random() % 4 == 0) {
            file.json["scenes"][0]["nodes"].push_back(count - 1);
        }
        expectSame(file.text());
        ASSERT_FALSE(HasFailure());
    }
}

}  // namespace
}  // namespace ribalta::test
