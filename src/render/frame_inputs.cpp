#include "render/frame_inputs.h"

namespace ribalta {

FrameInputs frameInputs(const Scene& scene, const Camera& camera, const FrameSettings& settings) {
    FrameInputs inputs{
        camera, settings, scene.spotLights, scene.pointLights, scene.directionalLights, {}, {}};
    inputs.worldFromLocal.reserve(scene.nodes.size());
    for (const Node& node : scene.nodes) {
        inputs.worldFromLocal.push_back(node.worldFromLocal);
    }
    for (const Deformer& deformer : scene.deformers) {
        inputs.shapes.push_back(deformer.shape);
    }
    return inputs;
}

}  // namespace ribalta
