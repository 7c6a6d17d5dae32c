#include "render/sheet_inputs.h"

#include <shared/slots.h>

#include "gl/counters.h"
#include "render/beam_program.h"

namespace ribalta {

SheetInputs::SheetInputs() {
    GLuint array = 0;
    glCreateVertexArrays(1, &array);
    vertexArray_ = Handle<deleteVertexArray>(array);
    depthSampler_ = makeDepthSampler();
}

void SheetInputs::bind(const BeamsWork& work, const GpuScene& gpuScene,
                       const ShadowTextures& shadows, const FrameTargets& targets) {
    const std::vector<gpu::BeamSettings> settings = {describeBeams(work)};
    settings_.write("beam settings", bytesOf(settings));
    tiles_.write("beam tiles", bytesOf(work.tiles.tiles));
    tileLamps_.write("lamps of the beam tiles", bytesOf(work.tiles.lamps));
    tileCount_ = int(work.tiles.tiles.size());
    glBindBufferBase(GL_UNIFORM_BUFFER, gpu::kBeamSettingsSlot, settings_.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, gpu::kTilesSlot, tiles_.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, gpu::kTileLampsSlot, tileLamps_.name());
    glBindTextureUnit(gpu::kShadowMapsUnit, shadows.maps->name());
    glBindSampler(gpu::kShadowMapsUnit, depthSampler_.name());
    if (work.shadowPyramid) {
        glBindTextureUnit(gpu::kShadowPyramidUnit, shadows.pyramid->name());
        if (work.countRuns) {
            const gpu::RunCounts none{};
            runCounts_.write("counts of runs", std::as_bytes(std::span(&none, 1)));
            glBindBufferBase(GL_SHADER_STORAGE_BUFFER, gpu::kRunCountsSlot, runCounts_.name());
        }
    }
    glBindTextureUnit(gpu::kLightMapsUnit, gpuScene.lightMaps().name());
    glBindTextureUnit(gpu::kDepthUnit, targets.depth.name());
}

void SheetInputs::unbind() {
    glBindSampler(gpu::kShadowMapsUnit, 0);
}

gpu::RunCounts SheetInputs::runCounts() const {
    gpu::RunCounts counts{};
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    runCounts_.read(std::as_writable_bytes(std::span(&counts, 1)));
    return counts;
}

void SheetInputs::drawTiles(const Program& program, Blend blend) const {
    PipelineState state;
    state.program = &program;
    state.vertexArray = vertexArray_.name();
    state.blend = blend;
    apply(state);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, tileCount_);
    ++glCounters().drawCalls;
}

}  // namespace ribalta
