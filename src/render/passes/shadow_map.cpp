#include "render/passes/shadow_map.h"

#include <glm/gtc/type_ptr.hpp>
#include <shared/slots.h>

#include "gl/counters.h"
#include "gl/pipeline_state.h"
#include "render/gpu_frame.h"

namespace ribalta {
namespace {

constexpr GLint kClipFromLocal = 0;

}  // namespace

void ShadowMapPass::makeLayers(const ShadowMaps& wanted) {
    if (maps_ && maps_.size().width == wanted.side && maps_.size().layers == wanted.layers) {
        return;
    }
    layers_.clear();
    maps_ = Texture2D("shadow maps", GL_DEPTH_COMPONENT32F,
                      {wanted.side, wanted.side, wanted.layers, 1});
    maps_.setSampling(GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE);
    // Lit where the point is as near as what the lamp sees, or nearer (reversed depth).
    glTextureParameteri(maps_.name(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTextureParameteri(maps_.name(), GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
    for (int layer = 0; layer < wanted.layers; ++layer) {
        layers_.emplace_back("shadow map " + std::to_string(layer), maps_, layer);
    }
}

void ShadowMapPass::draw(const std::vector<ShadowMapWork>& work, const Scene& scene,
                         const FramePlan& plan, const GpuScene& gpuScene) {
    makeLayers(plan.shadowMaps);
    for (const ShadowMapWork& map : work) {
        const glm::dmat4 clipFromWorld =
            shadowClipFromWorld(scene.spotLights[std::size_t(map.spot)], plan.shadowMaps.side);
        layers_[std::size_t(map.layer)].bind();
        // Clearing obeys the depth mask of the draw before.
        glDepthMask(GL_TRUE);
        const float farthest = 0.0F;
        glClearBufferfv(GL_DEPTH, 0, &farthest);
        const Program* current = nullptr;
        for (const int caster : map.casters) {
            const DrawItem& item = plan.draws[std::size_t(caster)];
            const bool mask = materialOf(scene, item).alphaMode == Material::AlphaMode::kMask;
            Program& program = mask ? masked_ : solid_;
            if (!program) {
                program = Program(
                    {"passes/shadow_map.vert", "passes/shadow_map.frag"},
                    mask ? std::vector<std::string>{"ALPHA_MASK"} : std::vector<std::string>{});
            }
            if (current != &program) {
                // Both sides cast: a thin wall has no inside.
                PipelineState state;
                state.program = &program;
                state.vertexArray = gpuScene.vertexArray();
                state.depthTest = DepthTest::kCloser;
                state.depthWrite = true;
                apply(state);
                current = &program;
            }
            const glm::mat4 clipFromLocal(clipFromWorld *
                                          scene.nodes[std::size_t(item.node)].worldFromLocal);
            glUniformMatrix4fv(kClipFromLocal, 1, GL_FALSE, glm::value_ptr(clipFromLocal));
            if (mask) {
                gpuScene.bindMaterial(scene, item);
            }
            const GpuScene::Geometry& geometry = gpuScene.geometry(item);
            glDrawElementsBaseVertex(geometry.mode, geometry.indexCount, GL_UNSIGNED_INT,
                                     reinterpret_cast<const void*>(geometry.indexOffset),
                                     geometry.baseVertex);
            ++glCounters().drawCalls;
        }
    }
}

}  // namespace ribalta
