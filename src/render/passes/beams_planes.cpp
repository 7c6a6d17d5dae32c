#include "render/passes/beams_planes.h"

#include <algorithm>

#include <shared/slots.h>

#include "gl/counters.h"
#include "gl/pipeline_state.h"
#include "render/beam_program.h"

namespace ribalta {
namespace {

constexpr GLint kLampIndex = 0;

}  // namespace

PlaneBeamsPass::PlaneBeamsPass() {
    GLuint array = 0;
    glCreateVertexArrays(1, &array);
    vertexArray_ = Handle<deleteVertexArray>(array);
}

void PlaneBeamsPass::draw(const BeamsWork& work, const GpuScene& gpuScene,
                          const Texture2D& shadowMaps, const FrameTargets& targets) {
    const bool cells = work.settings.cellsAcross > 0;
    Program& program = programs_[{work.phase, work.separateOutput, cells}];
    if (!program) {
        std::vector<std::string> defines = beamDefines(work);
        if (cells) {
            defines.emplace_back("CELLS");
        }
        program = Program({"passes/beams_planes.vert", "passes/beams_planes.frag"}, defines);
    }
    const std::vector<gpu::BeamSettings> settings = {describeBeams(work)};
    settings_.write("beam settings", bytesOf(settings));
    glBindBufferBase(GL_UNIFORM_BUFFER, gpu::kBeamSettingsSlot, settings_.name());
    glBindTextureUnit(gpu::kShadowMapsUnit, shadowMaps.name());
    glBindTextureUnit(gpu::kLightMapsUnit, gpuScene.lightMaps().name());

    targets.hazeWithDepth.bind();
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
}

}  // namespace ribalta
