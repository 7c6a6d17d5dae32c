#include "render/frame_inputs.h"

namespace ribalta {

std::vector<glm::dvec4> materialNumbers(const Scene& scene) {
    std::vector<glm::dvec4> numbers;
    for (const Dial& dial : scene.dials) {
        if (dial.list == Dial::List::kMaterials) {
            numbers.push_back(dial.now);
        }
    }
    return numbers;
}

FrameInputs frameInputs(const Scene& scene, const Camera& camera, const FrameSettings& settings) {
    FrameInputs inputs;
    inputs.camera = camera;
    inputs.settings = settings;
    inputs.spotLights = scene.spotLights;
    inputs.pointLights = scene.pointLights;
    inputs.directionalLights = scene.directionalLights;
    inputs.worldFromLocal.reserve(scene.nodes.size());
    inputs.isDrawn.reserve(scene.nodes.size());
    for (const Node& node : scene.nodes) {
        inputs.worldFromLocal.push_back(node.worldFromLocal);
        inputs.isDrawn.push_back(node.isDrawn());
    }
    for (const Deformer& deformer : scene.deformers) {
        inputs.shapes.push_back(deformer.shape);
    }
    inputs.materials = materialNumbers(scene);
    return inputs;
}

}  // namespace ribalta
