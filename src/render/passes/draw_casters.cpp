#include "render/passes/draw_casters.h"

#include <shared/surface.h>

#include "gl/pipeline_state.h"

namespace ribalta {

Texture2D makeShadowArray(const std::string& label, int side, int layers) {
    Texture2D maps(label, GL_DEPTH_COMPONENT32F, {side, side, layers, 1});
    maps.setSampling(GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE);
    glTextureParameteri(maps.name(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTextureParameteri(maps.name(), GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
    return maps;
}

void DrawCasters::draw(const std::vector<CasterLayer>& layers, const Scene& scene,
                       const std::vector<DrawItem>& draws, const GpuScene& gpuScene) {
    if (layers.empty()) {
        return;
    }
    std::vector<gpu::CasterInstance> instances;
    for (const CasterLayer& layer : layers) {
        for (const int caster : *layer.casters) {
            const DrawItem& item = draws[std::size_t(caster)];
            instances.push_back({glm::mat4(layer.clipFromWorld *
                                           scene.nodes[std::size_t(item.node)].worldFromLocal)});
        }
    }
    instances_.write("casters", bytesOf(instances));
    const GLuint vertexArray = gpuScene.geometry().castersAt(instances_);
    std::size_t firstInstance = 0;
    for (const CasterLayer& layer : layers) {
        drawLayer(layer, firstInstance, scene, draws, gpuScene, vertexArray);
        firstInstance += layer.casters->size();
    }
}

void DrawCasters::drawLayer(const CasterLayer& layer, std::size_t firstInstance, const Scene& scene,
                            const std::vector<DrawItem>& draws, const GpuScene& gpuScene,
                            GLuint vertexArray) {
    layer.layer->bind();
    // Clearing obeys the depth mask of the draw before.
    glDepthMask(GL_TRUE);
    const float farthest = 0.0F;
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    const Program* current = nullptr;
    const std::vector<int>& casters = *layer.casters;
    for (std::size_t first = 0, end = 0; first < casters.size(); first = end) {
        end = endOfInstances(scene, draws, casters, first);
        const DrawItem& item = draws[std::size_t(casters[first])];
        const bool mask = materialOf(scene, item).alphaMode == Material::AlphaMode::kMask;
        Program& program = mask ? masked_ : solid_;
        if (!program) {
            program =
                Program({"passes/shadow_map.vert", "passes/shadow_map.frag"},
                        mask ? std::vector<std::string>{"ALPHA_MASK"} : std::vector<std::string>{});
        }
        if (current != &program) {
            // Both sides cast: a thin wall has no inside.
            PipelineState state;
            state.program = &program;
            state.vertexArray = vertexArray;
            state.depthTest = DepthTest::kCloser;
            state.depthWrite = true;
            apply(state);
            current = &program;
        }
        if (mask) {
            gpuScene.bindMaterial(scene, item);
        }
        gpuScene.geometry().drawInstances(item, firstInstance + first, end - first);
    }
}

}  // namespace ribalta
