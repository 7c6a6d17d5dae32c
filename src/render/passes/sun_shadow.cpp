#include "render/passes/sun_shadow.h"

#include <cmath>

#include <shared/slots.h>
#include <shared/sun_shadow.h>

namespace ribalta {

static_assert(kMostSunCascades == gpu::kSunCascades);

SunShadowPass::SunShadowPass() {
    depthSampler_ = makeDepthSampler();
}

void SunShadowPass::draw(const SunShadowWork& work, const Scene& scene, const FramePlan& plan,
                         const GpuScene& gpuScene, DrawCasters& casters) {
    if (!maps_ || maps_.size().width != work.side || maps_.size().layers != work.layers) {
        layers_.clear();
        maps_ = {};
        maps_ = makeShadowArray("sun shadow maps", work.side, work.layers);
        for (int layer = 0; layer < work.layers; ++layer) {
            layers_.emplace_back("sun shadow map " + std::to_string(layer), maps_, layer);
        }
    }
    std::vector<CasterLayer> layers;
    for (std::size_t i = 0; i < work.cascades.size(); ++i) {
        const SunCascade& cascade = work.cascades[i];
        if (!cascade.kept) {
            layers.push_back({&layers_[i], cascade.clipFromWorld, &cascade.casters});
        }
    }
    casters.draw(layers, scene, plan.draws, gpuScene);
}

void SunShadowPass::bind(const SunShadowWork& work, const FramePlan& plan) {
    const glm::dmat3 sunFromView = work.sunFromWorld * glm::dmat3(worldFromView(plan.camera));
    const glm::dvec3 eye = work.sunFromWorld * plan.camera.frame.position;
    gpu::SunShadow frame{};
    frame.sunFromView = glm::dmat4(sunFromView);
    for (std::size_t i = 0; i < work.cascades.size(); ++i) {
        const SunCascade& cascade = work.cascades[i];
        frame.cascades[i] = glm::vec4(cascade.middle - eye, cascade.halfSide);
        frame.depths[i] = glm::vec4(1.0 / cascade.topMetres, work.texelMetres(cascade), 0.0, 0.0);
    }
    frame.sun = glm::vec4(std::tan(plan.settings.sky->air.sunAngularRadius), 0.0, 0.0, 0.0);
    frame.counts = glm::ivec4(work.cascades.size(), work.side, kSunMapMargin, 0);
    frame_.write("sun shadow", bytesOf(std::vector<gpu::SunShadow>{frame}));
    glBindBufferBase(GL_UNIFORM_BUFFER, gpu::kSunShadowSlot, frame_.name());
    glBindTextureUnit(gpu::kSunShadowUnit, maps_.name());
    glBindTextureUnit(gpu::kSunDepthUnit, maps_.name());
    glBindSampler(gpu::kSunDepthUnit, depthSampler_.name());
}

}  // namespace ribalta
