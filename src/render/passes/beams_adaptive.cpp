#include "render/passes/beams_adaptive.h"

#include <algorithm>
#include <cstring>

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

// Work groups for what a list of squares holds, which only the GPU knows.
void dispatchForList(const Buffer& list) {
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, list.name());
    glDispatchComputeIndirect(0);
    ++glCounters().drawCalls;
}

// An empty list with room for so many squares.
void beginList(Buffer& list, const char* name, GLuint slot, std::size_t squares) {
    gpu::SampledHead head{};
    head.groupsY = 1;
    head.groupsZ = 1;
    list.reserve(name, sizeof head + squares * sizeof(gpu::BeamSquare));
    list.write(name, std::as_bytes(std::span(&head, 1)));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, slot, list.name());
}

// What the GPU put into a list.
std::vector<gpu::BeamSquare> readList(const Buffer& list) {
    gpu::SampledHead head{};
    list.read(std::as_writable_bytes(std::span(&head, 1)));
    std::vector<std::byte> bytes(sizeof head + head.count * sizeof(gpu::BeamSquare));
    list.read(bytes);
    std::vector<gpu::BeamSquare> squares(head.count);
    std::memcpy(squares.data(), bytes.data() + sizeof head, bytes.size() - sizeof head);
    return squares;
}

void clear(const Texture2D& map) {
    const float dark[] = {0.0F, 0.0F, 0.0F, 0.0F};
    glClearTexImage(map.name(), 0, GL_RGBA, GL_FLOAT, dark);
}

}  // namespace

AdaptiveBeamsPass::AdaptiveBeamsPass()
    : cells_({"passes/beams_cells.comp"}),
      quads_({"passes/beams_quads.comp"}),
      exposure_({"BEAM_LATTICE"}) {}

AdaptiveBeamsPass::Programs& AdaptiveBeamsPass::programsFor(const BeamsWork& work) {
    Programs& programs = programs_[beamDefines(work)];
    if (!programs.fill) {
        const std::vector<std::string> defines = beamDefines(work);
        programs.lattice = Program({"passes/beams_lattice.comp"}, defines);
        programs.fine = Program({"passes/beams_fine.comp"}, defines);
        programs.fill = Program({"passes/beams_fill.comp"}, defines);
        programs.samples = Program({"passes/beams_samples.comp"}, defines);
    }
    return programs;
}

void AdaptiveBeamsPass::makeMaps(const BeamsWork& work, const FrameTargets& targets) {
    const glm::ivec2 points = work.latticePoints;
    const Texture2D::Size& picture = targets.color.size();
    const Texture2D::Size fine = {(picture.width + gpu::kFineStep - 1) / gpu::kFineStep,
                                  (picture.height + gpu::kFineStep - 1) / gpu::kFineStep, 0, 1};
    if (!fineMap_ || fineMap_.size().width != fine.width || fineMap_.size().height != fine.height) {
        latticeMap_ = Texture2D("beam lattice", GL_RGBA32F, {points.x, points.y, 0, 1});
        fineMap_ = Texture2D("fine beam lattice", GL_RGBA32F, fine);
        quadsMap_ = Texture2D("sampled quads", GL_R8, fine);
    }
    clear(latticeMap_);
    clear(fineMap_);
    clear(quadsMap_);
}

void AdaptiveBeamsPass::drawLattice(const BeamsWork& work, const Program& program) const {
    glBindImageTexture(gpu::kBeamLatticeUnit, latticeMap_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY,
                       GL_RGBA32F);
    glUseProgram(program.name());
    dispatchForCells(work);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

// The list of cells that interpolation does not fill well enough, and the finer lattice.
void AdaptiveBeamsPass::drawFineLattice(const BeamsWork& work, const Program& program) {
    const std::size_t cells = work.tiles.tiles.size() * gpu::kTileCells;
    beginList(sampledCells_, "sampled cells", gpu::kSampledCellsSlot, cells);
    glBindTextureUnit(gpu::kBeamLatticeUnit, latticeMap_.name());
    glBindImageTexture(gpu::kBeamFineUnit, fineMap_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY,
                       GL_RGBA32F);
    glUseProgram(cells_.name());
    dispatchForCells(work);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);

    glUseProgram(program.name());
    dispatchForList(sampledCells_);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

// The list of quads that interpolation does not fill well enough.
void AdaptiveBeamsPass::findQuads(const BeamsWork& work) {
    const std::size_t cells = work.tiles.tiles.size() * gpu::kTileCells;
    beginList(sampledQuads_, "sampled quads", gpu::kSampledQuadsSlot, cells * gpu::kCellQuads);
    glBindTextureUnit(gpu::kBeamFineUnit, fineMap_.name());
    glBindImageTexture(gpu::kBeamQuadsUnit, quadsMap_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R8);
    glUseProgram(quads_.name());
    dispatchForList(sampledCells_);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                    GL_COMMAND_BARRIER_BIT);
}

// What adds to the picture: interpolation, then the listed quads.
void AdaptiveBeamsPass::fillPicture(const BeamsWork& work, const Programs& programs,
                                    const FrameTargets& targets) const {
    glBindImageTexture(gpu::kColorUnit, targets.color.name(), 0, GL_FALSE, 0, GL_READ_WRITE,
                       GL_RGBA32F);
    if (work.separateOutput) {
        glBindImageTexture(gpu::kBeamsOutputUnit, targets.beams.name(), 0, GL_FALSE, 0,
                           GL_WRITE_ONLY, GL_RGBA32F);
    }
    glBindTextureUnit(gpu::kBeamQuadsUnit, quadsMap_.name());
    glUseProgram(programs.fill.name());
    dispatchForCells(work);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    glUseProgram(programs.samples.name());
    dispatchForList(sampledQuads_);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                    GL_FRAMEBUFFER_BARRIER_BIT);
}

std::uint64_t AdaptiveBeamsPass::sampledPixelLamps(const BeamsWork& work,
                                                   glm::ivec2 picture) const {
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    std::uint64_t sum = 0;
    for (const gpu::BeamSquare& tile : work.tiles.tiles) {
        sum += std::uint64_t(gpu::kTileCells) * std::uint64_t(tile.place.w);
    }
    for (const gpu::BeamSquare& cell : readList(sampledCells_)) {
        sum += std::uint64_t(gpu::kNewPoints) * std::uint64_t(cell.place.w);
    }
    for (const gpu::BeamSquare& quad : readList(sampledQuads_)) {
        // Its first pixel is a point of the finer lattice; some of the others may lie outside.
        const glm::ivec2 first = glm::ivec2(quad.place) * gpu::kFineStep;
        const glm::ivec2 pixels = glm::min(picture - first, glm::ivec2(gpu::kFineStep));
        sum += std::uint64_t(pixels.x * pixels.y - 1) * std::uint64_t(quad.place.w);
    }
    return sum;
}

void AdaptiveBeamsPass::draw(const BeamsWork& work, const GpuScene& gpuScene,
                             const ShadowTextures& shadows, const FrameTargets& targets) {
    const Programs& programs = programsFor(work);
    makeMaps(work, targets);
    inputs_.bind(work, gpuScene, shadows, targets);
    drawLattice(work, programs.lattice);

    glBindTextureUnit(gpu::kBeamLatticeUnit, latticeMap_.name());
    exposure_.draw(work.ev100, work.toneCurve, targets.color);
    glBindTextureUnit(gpu::kColorUnit, targets.color.name());
    drawFineLattice(work, programs.fine);
    findQuads(work);

    fillPicture(work, programs, targets);
    inputs_.unbind();
}

}  // namespace ribalta
