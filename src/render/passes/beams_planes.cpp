#include "render/passes/beams_planes.h"

#include <algorithm>

#include <shared/slots.h>

#include "gl/counters.h"
#include "gl/pipeline_state.h"
#include "render/beam_program.h"

namespace ribalta {
namespace {

constexpr GLint kLampIndex = 0;
constexpr GLint kFullScale = 1;

}  // namespace

PlaneBeamsPass::PlaneBeamsPass() {
    GLuint array = 0;
    glCreateVertexArrays(1, &array);
    vertexArray_ = Handle<deleteVertexArray>(array);
}

void PlaneBeamsPass::draw(const BeamsWork& work, const GpuScene& gpuScene,
                          const Texture2D& shadowMaps, const FrameTargets& targets) {
    const bool cells = work.settings.cellsAcross > 0;
    const bool eightBit = work.settings.eightBitBlending;
    std::vector<std::string> defines = beamDefines(work);
    if (cells) {
        defines.emplace_back("CELLS");
    }
    if (eightBit) {
        defines.emplace_back("EIGHT_BIT");
    }
    Program& program = programs_[defines];
    if (!program) {
        program = Program({"passes/beams_planes.vert", "passes/beams_planes.frag"}, defines);
    }
    const std::vector<gpu::BeamSettings> settings = {describeBeams(work)};
    settings_.write("beam settings", bytesOf(settings));
    glBindBufferBase(GL_UNIFORM_BUFFER, gpu::kBeamSettingsSlot, settings_.name());
    glBindTextureUnit(gpu::kShadowMapsUnit, shadowMaps.name());
    glBindTextureUnit(gpu::kLightMapsUnit, gpuScene.lightMaps().name());

    if (eightBit) {
        makeEightBitTarget(targets);
        codesWithDepth_.bind();
        const float black[] = {0.0F, 0.0F, 0.0F, 0.0F};
        glClearBufferfv(GL_COLOR, 0, black);
        glProgramUniform1f(program.name(), kFullScale, float(work.fullScale));
    } else {
        targets.hazeWithDepth.bind();
    }
    PipelineState state;
    state.program = &program;
    state.vertexArray = vertexArray_.name();
    state.depthTest = DepthTest::kCloser;
    state.blend = Blend::kAdd;
    apply(state);
    const int cellCount =
        std::max(1, work.settings.cellsAcross) * std::max(1, work.settings.cellsDown);
    for (const int lamp : work.lamps) {
        program.setInt(kLampIndex, lamp);
        glDrawArraysInstanced(GL_TRIANGLES, 0, 6 * cellCount, work.settings.planes);
        ++glCounters().drawCalls;
    }
    if (eightBit) {
        addEightBits(work, targets);
    }
}

void PlaneBeamsPass::makeEightBitTarget(const FrameTargets& targets) {
    const Texture2D::Size size = targets.color.size();
    if (codes_ && codes_.size().width == size.width && codes_.size().height == size.height &&
        depthOfCodes_ == targets.depth.name()) {
        return;
    }
    codes_ = Texture2D("eight-bit beams", GL_RGBA8, {size.width, size.height, 0, 1});
    codesWithDepth_ = Framebuffer("eight-bit beams", {&codes_}, &targets.depth);
    depthOfCodes_ = targets.depth.name();
}

void PlaneBeamsPass::addEightBits(const BeamsWork& work, const FrameTargets& targets) {
    Program& program = addPrograms_[work.separateOutput];
    if (!program) {
        program = Program({"passes/full_screen.vert", "passes/beams_planes_eight_bit.frag"},
                          work.separateOutput ? std::vector<std::string>{"BEAMS_OUTPUT"}
                                              : std::vector<std::string>{});
    }
    glProgramUniform1f(program.name(), kFullScale, float(work.fullScale));
    targets.haze.bind();
    PipelineState state;
    state.program = &program;
    state.vertexArray = vertexArray_.name();
    state.blend = Blend::kAdd;
    apply(state);
    glBindTextureUnit(gpu::kColorUnit, codes_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    ++glCounters().drawCalls;
}

}  // namespace ribalta
