#include "render/passes/shadow_pyramid.h"

#include <shared/slots.h>

#include "gl/counters.h"
#include "gl/work_groups.h"

namespace ribalta {
namespace {

constexpr GLint kSourceLevel = 0;
constexpr int kFinestBlock = 4;   // texels of the map
constexpr int kPyramidGroup = 8;  // texels, each way

}  // namespace

ShadowPyramidPass::ShadowPyramidPass()
    : fromMaps_({"passes/shadow_pyramid.comp"}, {"FROM_MAPS"}),
      fromLevel_({"passes/shadow_pyramid.comp"}) {
    depthSampler_ = makeDepthSampler();
}

void ShadowPyramidPass::draw(const std::vector<int>& layers, const Texture2D& shadowMaps) {
    const int side = shadowMaps.size().width / kFinestBlock;
    if (!pyramid_ || pyramid_.size().width != side ||
        pyramid_.size().layers != shadowMaps.size().layers) {
        pyramid_ =
            Texture2D("shadow pyramid", GL_RG32F,
                      {side, side, shadowMaps.size().layers, Texture2D::fullLevels(side, side)});
        pyramid_.setSampling(GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST, GL_CLAMP_TO_EDGE,
                             GL_CLAMP_TO_EDGE);
    }
    layers_.write("layers of the shadow pyramid", bytesOf(layers));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, gpu::kPyramidLayersSlot, layers_.name());
    glBindTextureUnit(gpu::kShadowMapsUnit, shadowMaps.name());
    glBindSampler(gpu::kShadowMapsUnit, depthSampler_.name());
    glBindTextureUnit(gpu::kShadowPyramidUnit, pyramid_.name());
    for (int level = 0; level < pyramid_.size().levels; ++level) {
        const Program& program = level == 0 ? fromMaps_ : fromLevel_;
        if (level > 0) {
            program.setInt(kSourceLevel, level - 1);
        }
        glUseProgram(program.name());
        glBindImageTexture(gpu::kPyramidUnit, pyramid_.name(), level, GL_TRUE, 0, GL_WRITE_ONLY,
                           GL_RG32F);
        const GLuint groups = workGroups(side >> level, kPyramidGroup);
        glDispatchCompute(groups, groups, GLuint(layers.size()));
        ++glCounters().drawCalls;
        glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    }
    glBindSampler(gpu::kShadowMapsUnit, 0);
}

}  // namespace ribalta
