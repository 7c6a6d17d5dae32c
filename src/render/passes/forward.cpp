#include "render/passes/forward.h"

#include <shared/slots.h>
#include <shared/surface.h>

#include "gl/counters.h"
#include "gl/pipeline_state.h"

namespace ribalta {

const Program& ForwardPass::program(const Variant& variant) {
    Program& program = programs_[variant];
    if (!program) {
        std::vector<std::string> defines;
        if (variant.textures) {
            defines.emplace_back("TEXTURES");
        }
        if (variant.alphaMask) {
            defines.emplace_back("ALPHA_MASK");
        }
        if (variant.normalOutput) {
            defines.emplace_back("NORMAL_OUTPUT");
        }
        if (variant.sky) {
            defines.emplace_back("SKY");
        }
        if (variant.illuminance) {
            defines.emplace_back("ILLUMINANCE");
        }
        if (variant.layers) {
            defines.emplace_back("LAYERS");
        }
        if (variant.seenThrough) {
            defines.emplace_back("SEEN_THROUGH");
        }
        if (variant.sunShadow) {
            defines.emplace_back("SUN_SHADOW");
        }
        program = Program({"passes/forward.vert", "passes/forward.frag"}, defines);
    }
    return program;
}

void ForwardPass::drawItem(const Scene& scene, const FramePlan& plan, const GpuScene& gpuScene,
                           const GpuFrame& frame, int index, bool blended, bool normalOutput,
                           bool seenThrough) {
    const DrawItem& item = plan.draws[std::size_t(index)];
    const Material& material = materialOf(scene, item);
    const glm::dmat4& worldFromLocal = scene.nodes[std::size_t(item.node)].worldFromLocal;

    // What passes through a thin wall has a colour, which alpha has not: first it tints what is
    // behind, then the wall's own light is added.
    const bool transmits = material.layers && material.layers->transmission > 0.0F && blended;
    if (transmits && !seenThrough) {
        drawItem(scene, plan, gpuScene, frame, index, blended, normalOutput, true);
    }

    PipelineState state;
    state.program = &program({.textures = gpuScene.hasTextures(item) || gpuScene.hasLayers(item),
                              .alphaMask = material.alphaMode == Material::AlphaMode::kMask,
                              .normalOutput = normalOutput,
                              .sky = plan.sky.has_value(),
                              .sunShadow = plan.sunShadow.has_value(),
                              .illuminance = plan.settings.illuminance.has_value(),
                              .layers = gpuScene.hasLayers(item),
                              .seenThrough = seenThrough});
    state.vertexArray = gpuScene.vertexArray();
    state.depthTest = blended ? DepthTest::kCloserOrEqual : DepthTest::kCloser;
    state.depthWrite = !blended;
    state.blend = seenThrough ? Blend::kTint
                  : transmits ? Blend::kAdd
                  : blended   ? Blend::kAlpha
                              : Blend::kReplace;
    state.cullBackFaces = !material.doubleSided;
    state.clockwiseFront = glm::determinant(glm::dmat3(worldFromLocal)) < 0.0;
    apply(state);

    gpuScene.bindMaterial(scene, item);
    frame.bindDraw(index);
    const GpuScene::Geometry& geometry = gpuScene.geometry(item);
    glDrawElementsBaseVertex(geometry.mode, geometry.indexCount, GL_UNSIGNED_INT,
                             reinterpret_cast<const void*>(geometry.indexOffset),
                             geometry.baseVertex);
    ++glCounters().drawCalls;
}

void ForwardPass::draw(const ForwardWork& work, const Scene& scene, const FramePlan& plan,
                       const GpuScene& gpuScene, const GpuFrame& frame, const Texture2D& shadowMaps,
                       const FrameTargets& targets) {
    targets.surfaces.bind();
    glEnable(GL_PROGRAM_POINT_SIZE);
    glBindTextureUnit(gpu::kShadowMapsUnit, shadowMaps.name());
    glBindTextureUnit(gpu::kLightMapsUnit, gpuScene.lightMaps().name());
    for (const int index : work.opaque) {
        drawItem(scene, plan, gpuScene, frame, index, false, work.normalOutput);
    }
    for (const int index : work.blended) {
        drawItem(scene, plan, gpuScene, frame, index, true, work.normalOutput);
    }
    glDisable(GL_PROGRAM_POINT_SIZE);
    for (int t = 0; t < gpu::kMaterialTextures; ++t) {
        glBindSampler(GLuint(gpu::kMaterialTexturesUnit + t), 0);
    }
    for (int t = 0; t < gpu::kLayerTextures; ++t) {
        glBindSampler(GLuint(gpu::kLayerTexturesUnit + t), 0);
    }
}

}  // namespace ribalta
