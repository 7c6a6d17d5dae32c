// Prints where a scene's nodes are, and what shape its meshes have, at given times, for comparison
// with another program's answer. A line of JSON a time: "nodes", 16 numbers each, worldFromLocal
// column by column, in the order of Scene::nodes without those that only hold a skinned mesh;
// "shown", the same nodes' visibility; "lamps" and "cameras", what can be animated of them, in the
// order of the nodes that they hang on; "materials", base colour and emission; and "deformers",
// each with its weights, its joints' worldFromMesh, and of each of its primitives
// every so manieth corner in the order of the indices, in world metres. Not a test itself.
#include <algorithm>
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

bool holdsSkinnedMesh(const Scene& scene, const Node& node) {
    return node.deformer >= 0 && scene.deformers[std::size_t(node.deformer)].skin >= 0;
}

// Infinity is no JSON.
double finite(double number) {
    return std::min(number, 1e30);
}

void addLight(const glm::vec3& color, double intensity, double range, List& list) {
    for (const double number :
         {double(color.x), double(color.y), double(color.z), intensity, finite(range)}) {
        list.add(number);
    }
}

void printLamps(const Scene& scene) {
    List list;
    for (int node = 0; node < int(scene.nodes.size()); ++node) {
        for (const SpotLight& lamp : scene.spotLights) {
            if (lamp.node == node) {
                addLight(lamp.color, lamp.intensityCandela, lamp.rangeMetres, list);
                list.add(lamp.innerConeAngle);
                list.add(lamp.outerConeAngle);
            }
        }
        for (const PointLight& lamp : scene.pointLights) {
            if (lamp.node == node) {
                addLight(lamp.color, lamp.intensityCandela, lamp.rangeMetres, list);
            }
        }
        for (const DirectionalLight& lamp : scene.directionalLights) {
            if (lamp.node == node) {
                addLight(lamp.color, lamp.illuminanceLux, 0.0, list);
            }
        }
    }
}

void printCameras(const Scene& scene) {
    List list;
    for (const Camera& camera : scene.cameras) {
        list.add(camera.nearMetres);
        list.add(finite(camera.farMetres));
        if (const auto* lens = std::get_if<PerspectiveLens>(&camera.lens)) {
            list.add(lens->verticalFov);
            list.add(lens->aspectRatio.value_or(0.0));
        } else {
            const auto& box = std::get<OrthographicLens>(camera.lens);
            list.add(box.halfWidth);
            list.add(box.halfHeight);
        }
    }
}

void printMaterials(const Scene& scene) {
    List list;
    for (const Material& material : scene.materials) {
        for (int c = 0; c < 4; ++c) {
            list.add(double(material.baseColor[c]));
        }
        for (int c = 0; c < 3; ++c) {
            list.add(double(material.emission[c]));
        }
    }
}

void printPose(const Scene& scene) {
    std::printf("{\"nodes\":");
    {
        List list;
        for (const Node& node : scene.nodes) {
            if (!holdsSkinnedMesh(scene, node)) {
                list.add(node.worldFromLocal);
            }
        }
    }
    std::printf(",\"shown\":");
    {
        List list;
        for (const Node& node : scene.nodes) {
            if (!holdsSkinnedMesh(scene, node)) {
                list.add(node.shown ? 1.0 : 0.0);
            }
        }
    }
    std::printf(",\"lamps\":");
    printLamps(scene);
    std::printf(",\"cameras\":");
    printCameras(scene);
    std::printf(",\"materials\":");
    printMaterials(scene);
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
