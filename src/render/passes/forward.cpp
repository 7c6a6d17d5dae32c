#include "render/passes/forward.h"

#include <shared/slots.h>
#include <shared/surface.h>

#include "gl/pipeline_state.h"

namespace ribalta {
namespace {

bool transmitsLight(const Material& material) {
    return material.layers && material.layers->transmission > 0.0F;
}

}  // namespace

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

void ForwardPass::drawRun(const Scene& scene, const FramePlan& plan, const GpuScene& gpuScene,
                          GLuint vertexArray, const Run& run) {
    const DrawItem& item = plan.draws[std::size_t(run.draw)];
    const Material& material = materialOf(scene, item);

    // What passes through a thin wall has a colour, which alpha has not: first it tints what is
    // behind, then the wall's own light is added.
    const bool transmits = transmitsLight(material) && run.blended;
    if (transmits && !run.seenThrough) {
        Run tint = run;
        tint.seenThrough = true;
        drawRun(scene, plan, gpuScene, vertexArray, tint);
    }

    PipelineState state;
    state.program = &program({.textures = gpuScene.hasTextures(item) || gpuScene.hasLayers(item),
                              .alphaMask = material.alphaMode == Material::AlphaMode::kMask,
                              .normalOutput = plan.forward->normalOutput,
                              .sky = plan.sky.has_value(),
                              .sunShadow = plan.sunShadow.has_value(),
                              .illuminance = plan.settings.illuminance.has_value(),
                              .layers = gpuScene.hasLayers(item),
                              .seenThrough = run.seenThrough});
    state.vertexArray = vertexArray;
    state.depthTest = run.blended ? DepthTest::kCloserOrEqual : DepthTest::kCloser;
    state.depthWrite = !run.blended;
    state.blend = run.seenThrough ? Blend::kTint
                  : transmits     ? Blend::kAdd
                  : run.blended   ? Blend::kAlpha
                                  : Blend::kReplace;
    state.cullBackFaces = !material.doubleSided;
    state.clockwiseFront = item.mirrored;
    apply(state);

    gpuScene.bindMaterial(scene, item);
    gpuScene.geometry().drawInstances(item, run.firstInstance, run.instances);
}

void ForwardPass::draw(const ForwardWork& work, const Scene& scene, const FramePlan& plan,
                       const GpuScene& gpuScene, const GpuFrame& frame, const Texture2D& shadowMaps,
                       const FrameTargets& targets) {
    targets.surfaces.bind();
    glEnable(GL_PROGRAM_POINT_SIZE);
    glBindTextureUnit(gpu::kShadowMapsUnit, shadowMaps.name());
    glBindTextureUnit(gpu::kLightMapsUnit, gpuScene.lightMaps().name());
    const GLuint vertexArray = gpuScene.geometry().surfacesAt(frame.surfaces());
    std::size_t before = 0;  // instances of the lists drawn so far
    for (const auto* list : {&work.opaque, &work.blended}) {
        const bool blended = list == &work.blended;
        for (std::size_t first = 0, end = 0; first < list->size(); first = end) {
            const int draw = (*list)[first];
            // Tinting and adding take turns, one wall at a time.
            end = blended && transmitsLight(materialOf(scene, plan.draws[std::size_t(draw)]))
                      ? first + 1
                      : endOfInstances(scene, plan.draws, *list, first);
            drawRun(scene, plan, gpuScene, vertexArray,
                    {draw, before + first, end - first, blended});
        }
        before += list->size();
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
