#include "render/passes/draw_casters.h"

#include <glm/gtc/type_ptr.hpp>

#include "gl/counters.h"
#include "gl/pipeline_state.h"

namespace ribalta {
namespace {

constexpr GLint kClipFromLocal = 0;

}  // namespace

Texture2D makeShadowArray(const std::string& label, int side, int layers) {
    Texture2D maps(label, GL_DEPTH_COMPONENT32F, {side, side, layers, 1});
    maps.setSampling(GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE);
    glTextureParameteri(maps.name(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTextureParameteri(maps.name(), GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
    return maps;
}

void DrawCasters::draw(const Framebuffer& layer, const glm::dmat4& clipFromWorld,
                       const std::vector<int>& casters, const Scene& scene,
                       const std::vector<DrawItem>& draws, const GpuScene& gpuScene) {
    layer.bind();
    // Clearing obeys the depth mask of the draw before.
    glDepthMask(GL_TRUE);
    const float farthest = 0.0F;
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    const Program* current = nullptr;
    for (const int caster : casters) {
        const DrawItem& item = draws[std::size_t(caster)];
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

}  // namespace ribalta
