// Prints where a scene's nodes are, and what shape its meshes have, at given times, for comparison
// with another program's answer. A line of JSON a time: "nodes", 16 numbers each, worldFromLocal
// column by column, in the order of Scene::nodes without those that only hold a skinned mesh; and
// "deformers", each with its weights, its joints' worldFromMesh, and of each of its primitives
// every so manieth corner in the order of the indices, in world metres. Not a test itself.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "gltf/load_gltf.h"

namespace {

using namespace ribalta;

constexpr std::size_t kCorners = 40;  // looked at of a primitive

// A JSON list, element by element.
class List {
  public:
    List() { std::printf("["); }
    ~List() { std::printf("]"); }
    List(const List&) = delete;
    List& operator=(const List&) = delete;

    void next() {
        std::printf("%s", isFirst_ ? "" : ",");
        isFirst_ = false;
    }
    void add(double number) {
        next();
        std::printf("%.9g", number);
    }
    void add(const glm::dmat4& matrix) {
        for (int i = 0; i < 16; ++i) {
            add(matrix[i / 4][i % 4]);
        }
    }

  private:
    bool isFirst_ = true;
};

void printCorners(const Primitive& primitive, const Deformer& deformer, const Node& node) {
    const DeformedVertices vertices = deformVertices(primitive, deformer);
    const std::size_t step = (primitive.indices.size() + kCorners - 1) / kCorners;
    List list;
    list.add(double(primitive.indices.size()));
    for (std::size_t i = 0; i < primitive.indices.size(); i += step) {
        const glm::dvec4 world =
            node.worldFromLocal *
            glm::dvec4(glm::dvec3(vertices.positions[primitive.indices[i]]), 1.0);
        for (int axis = 0; axis < 3; ++axis) {
            list.add(world[axis]);
        }
    }
}

void printDeformer(const Scene& scene, const Deformer& deformer) {
    const Node& node = scene.nodes[std::size_t(deformer.node)];
    std::printf("{\"weights\":");
    {
        List list;
        for (const float weight : deformer.weights) {
            list.add(double(weight));
        }
    }
    std::printf(",\"joints\":");
    {
        List list;
        for (const glm::mat4& matrix : deformer.localFromMesh) {
            list.add(node.worldFromLocal * glm::dmat4(matrix));
        }
    }
    std::printf(",\"primitives\":");
    {
        List list;
        for (const Primitive& primitive : scene.meshes[std::size_t(node.mesh)].primitives) {
            list.next();
            printCorners(primitive, deformer, node);
        }
    }
    std::printf("}");
}

void printPose(const Scene& scene) {
    std::printf("{\"nodes\":");
    {
        List list;
        for (const Node& node : scene.nodes) {
            if (node.deformer < 0 || scene.deformers[std::size_t(node.deformer)].skin < 0) {
                list.add(node.worldFromLocal);
            }
        }
    }
    std::printf(",\"deformers\":");
    {
        List list;
        for (const Deformer& deformer : scene.deformers) {
            list.next();
            printDeformer(scene, deformer);
        }
    }
    std::printf("}\n");
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) {
        std::fputs("usage: pose_nodes SCENE ANIMATION|-1|rest SECONDS...\n", stderr);
        return 2;
    }
    try {
        Scene scene = loadGltf(argv[1]).scene;
        const bool rests = std::string(argv[2]) == "rest";
        const int animation = std::atoi(argv[2]);
        for (int i = 3; i < argc; ++i) {
            if (!rests) {
                poseScene(scene, std::atof(argv[i]), animation);
            }
            printPose(scene);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
    return 0;
}
