#include "render/passes/beams_adaptive.h"

#include <algorithm>

#include <shared/slots.h>

#include "gl/counters.h"
#include "render/beam_program.h"

namespace ribalta {
namespace {

// An invocation for each of the tiles' cells, or as many as may be at once.
void dispatchForCells(const BeamsWork& work) {
    const std::size_t cells = work.tiles.tiles.size() * gpu::kTileCells;
    const std::size_t groups = (cells + gpu::kBeamGroup - 1) / gpu::kBeamGroup;
    glDispatchCompute(GLuint(std::min<std::size_t>(groups, gpu::kMaxBeamGroups)), 1, 1);
    ++glCounters().drawCalls;
}

}  // namespace

AdaptiveBeamsPass::AdaptiveBeamsPass()
    : cells_({"passes/beams_cells.comp"}), exposure_({"BEAM_LATTICE"}) {}

AdaptiveBeamsPass::Programs& AdaptiveBeamsPass::programsFor(const BeamsWork& work) {
    Programs& programs = programs_[beamDefines(work)];
    if (!programs.fill) {
        const std::vector<std::string> defines = beamDefines(work);
        programs.lattice = Program({"passes/beams_lattice.comp"}, defines);
        programs.fill = Program({"passes/beams_tiles.vert", "passes/beams_fill.frag"}, defines);
        programs.samples = Program({"passes/beams_samples.comp"}, defines);
    }
    return programs;
}

void AdaptiveBeamsPass::makeLattice(const glm::ivec2& points) {
    if (latticeMap_ && latticeMap_.size().width == points.x &&
        latticeMap_.size().height == points.y) {
        return;
    }
    latticeMap_ = Texture2D("beam lattice", GL_RGBA32F, {points.x, points.y, 0, 1});
    cellsMap_ = Texture2D("beam lattice cells", GL_R8, {points.x, points.y, 0, 1});
}

// The list of cells that interpolation does not fill well enough.
void AdaptiveBeamsPass::findCells(const BeamsWork& work, const FrameTargets& targets) {
    gpu::SampledCellsHead head{};
    head.groupsY = 1;
    head.groupsZ = 1;
    const std::size_t cells = work.tiles.tiles.size() * gpu::kTileCells;
    sampledCells_.reserve("sampled cells", sizeof head + cells * sizeof(glm::ivec4));
    sampledCells_.write("sampled cells", std::as_bytes(std::span(&head, 1)));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, gpu::kSampledCellsSlot, sampledCells_.name());
    glBindTextureUnit(gpu::kColorUnit, targets.color.name());
    glBindImageTexture(gpu::kBeamCellsUnit, cellsMap_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R8);
    glUseProgram(cells_.name());
    dispatchForCells(work);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                    GL_COMMAND_BARRIER_BIT);
}

void AdaptiveBeamsPass::sampleCells(const BeamsWork& work, const Program& program,
                                    const FrameTargets& targets) {
    glBindImageTexture(gpu::kColorUnit, targets.color.name(), 0, GL_FALSE, 0, GL_READ_WRITE,
                       GL_RGBA32F);
    if (work.separateOutput) {
        glBindImageTexture(gpu::kBeamsOutputUnit, targets.beams.name(), 0, GL_FALSE, 0,
                           GL_WRITE_ONLY, GL_RGBA32F);
    }
    glUseProgram(program.name());
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, sampledCells_.name());
    glDispatchComputeIndirect(0);
    ++glCounters().drawCalls;
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                    GL_FRAMEBUFFER_BARRIER_BIT);
}

void AdaptiveBeamsPass::draw(const BeamsWork& work, const GpuScene& gpuScene,
                             const ShadowTextures& shadows, const FrameTargets& targets) {
    const Programs& programs = programsFor(work);
    makeLattice(work.latticePoints);
    inputs_.bind(work, gpuScene, shadows, targets);

    const float dark[] = {0.0F, 0.0F, 0.0F, 0.0F};
    glClearTexImage(latticeMap_.name(), 0, GL_RGBA, GL_FLOAT, dark);
    glBindImageTexture(gpu::kBeamLatticeUnit, latticeMap_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY,
                       GL_RGBA32F);
    glUseProgram(programs.lattice.name());
    dispatchForCells(work);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);

    glBindTextureUnit(gpu::kBeamLatticeUnit, latticeMap_.name());
    exposure_.draw(work.ev100, targets.color);
    findCells(work, targets);

    targets.haze.bind();
    glBindTextureUnit(gpu::kBeamCellsUnit, cellsMap_.name());
    inputs_.drawTiles(programs.fill, Blend::kAdd);
    sampleCells(work, programs.samples, targets);
    inputs_.unbind();
}

}  // namespace ribalta
