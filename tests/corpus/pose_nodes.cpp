// Prints where a scene's nodes are at given times, for comparison with another program's answer:
// a line a time, on it 16 numbers a node, worldFromLocal column by
// column, in the order of Scene::nodes. Not a test itself.
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "gltf/load_gltf.h"

int main(int argc, char** argv) {
    if (argc < 4) {
        std::fputs("usage: pose_nodes SCENE ANIMATION|-1 SECONDS...\n", stderr);
        return 2;
    }
    try {
        ribalta::Scene scene = ribalta::loadGltf(argv[1]).scene;
        const int animation = std::atoi(argv[2]);
        for (int i = 3; i < argc; ++i) {
            ribalta::poseScene(scene, std::atof(argv[i]), animation);
            for (const ribalta::Node& node : scene.nodes) {
                for (int n = 0; n < 16; ++n) {
                    std::printf("%.9g ", node.worldFromLocal[n / 4][n % 4]);
                }
            }
            std::printf("\n");
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
    return 0;
}
