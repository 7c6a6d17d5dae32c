#include "render/passes/shadow_map.h"

#include "render/gpu_frame.h"

namespace ribalta {

void ShadowMapPass::makeLayers(const ShadowMaps& wanted) {
    if (maps_ && maps_.size().width == wanted.side && maps_.size().layers == wanted.layers) {
        return;
    }
    layers_.clear();
    maps_ = makeShadowArray("shadow maps", wanted.side, wanted.layers);
    for (int layer = 0; layer < wanted.layers; ++layer) {
        layers_.emplace_back("shadow map " + std::to_string(layer), maps_, layer);
    }
}

void ShadowMapPass::draw(const std::vector<ShadowMapWork>& work, const Scene& scene,
                         const FramePlan& plan, const GpuScene& gpuScene, DrawCasters& casters) {
    makeLayers(plan.shadowMaps);
    std::vector<CasterLayer> layers;
    layers.reserve(work.size());
    for (const ShadowMapWork& map : work) {
        layers.push_back(
            {&layers_[std::size_t(map.layer)],
             shadowClipFromWorld(scene.spotLights[std::size_t(map.spot)], plan.shadowMaps.side),
             &map.casters});
    }
    casters.draw(layers, scene, plan.draws, gpuScene);
}

}  // namespace ribalta
