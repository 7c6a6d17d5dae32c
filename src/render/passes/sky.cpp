#include "render/passes/sky.h"

#include <cmath>
#include <cstring>
#include <utility>

#include <shared/sky.h>
#include <shared/slots.h>

#include "gl/counters.h"
#include "gl/work_groups.h"

namespace ribalta {
namespace {

constexpr double kSmallestHaze = 5.0;  // metres
constexpr double kAtTheTop = 10.0;     // metres

Texture2D table(const std::string& label, const Texture2D::Size& size, GLenum format = GL_RGBA32F) {
    Texture2D texture(label, format, size);
    texture.setSampling(GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE);
    return texture;
}

}  // namespace

void SkyPass::prepareTables(const SkyWork& work) {
    if (work.drawing.isOwn()) {
        textures_.make(work.drawing.air, work.drawing.orders, files_);
        baseline_.reset();
    } else {
        BaselineSky made(work.drawing.air, work.drawing.model);
        baseline_ = std::move(made);
        textures_ = {};
        viewTable_ = {};
        aerialTable_ = {};
    }
}

const SkyLighting& SkyPass::prepare(const SkyWork& work) {
    if (work.makeTables) {
        prepareTables(work);
    }
    const std::vector<std::string> defines = baseline_ ? baseline_->defines() : textures_.defines();
    if (defines != defines_) {
        defines_ = defines;
        view_ = {};
        edgesProgram_ = {};
        edgeTilesProgram_ = {};
        aerial_ = {};
        composite_.clear();
    }
    if (lit_ != work.drawing) {
        lighting_ = baseline_ ? baseline_->lighting(work.drawing)
                              : skyLighting(work.drawing, textures_.tables());
        lit_ = work.drawing;
    }
    return lighting_;
}

void SkyPass::uploadFrame(const SkyWork& work, const Camera& camera) {
    const glm::dmat3 turn(viewFromWorld(camera));
    const glm::dvec3 suns = baseline_ ? glm::dvec3(0.0) : textures_.tables().suns();
    gpu::SkyFrame frame{};
    frame.worldFromView = worldFromView(camera);
    // Seen from just below the air's end there is nothing above that counts, but an edge in the
    // light that rows of the view's table would blur.
    const double top = work.drawing.air.topMetres;
    const double height =
        std::abs(work.eye.heightMetres - top) < kAtTheTop ? top : work.eye.heightMetres;
    frame.zenith = glm::vec4(turn * work.eye.zenith, height);
    frame.sun = glm::vec4(turn * work.drawing.towardsSun, work.eye.muS);
    frame.sunward = glm::vec4(turn * lighting_.sunward, 0.0);
    frame.suns = glm::vec4(suns, 0.0);
    frame.aerial = glm::vec4(work.aerialKey.farthestMetres, 0.0, 0.0, 0.0);
    if (!work.haze.isEmpty()) {
        const glm::dvec3 size = glm::max(work.haze.halfSize(), glm::dvec3(kSmallestHaze));
        frame.hazeMiddle = glm::vec4(work.haze.centre(), 0.0);
        frame.hazePerMetre = glm::vec4(1.0 / size, 1.0);
    }
    frame.sunLux = glm::vec4(lighting_.sunLux, 0.0);
    const glm::dvec3 sides[] = {lighting_.lux.up, lighting_.lux.down, lighting_.lux.towardsSun,
                                lighting_.lux.awayFromSun, lighting_.lux.across};
    for (int i = 0; i < 5; ++i) {
        frame.irradiance[i] = glm::vec4(sides[i], 0.0);
    }
    const std::vector<gpu::SkyFrame> frames = {frame};
    frame_.write("sky", bytesOf(frames));
    glBindBufferBase(GL_UNIFORM_BUFFER, gpu::kSkySlot, frame_.name());
}

void SkyPass::makeTable(Program& program, const std::string& shader, const Texture2D& table,
                        glm::ivec3 size) {
    if (!program) {
        program = Program({shader}, defines_);
    }
    glUseProgram(program.name());
    glBindImageTexture(gpu::kSkyTableUnit, table.name(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    glDispatchCompute(workGroups(size.x, gpu::kSkyGroup), workGroups(size.y, gpu::kSkyGroup),
                      GLuint(size.z));
    ++glCounters().drawCalls;
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void SkyPass::makeViewTable(const SkyWork& work) {
    if (!viewTable_) {
        viewTable_ = table("sky view", {gpu::kSkyViewAzimuths, gpu::kSkyViewAngles, 4, 1});
    }
    makeTable(view_, "passes/sky_view.comp", viewTable_,
              {gpu::kSkyViewAzimuths, gpu::kSkyViewAngles, 2});
    if (work.edges) {
        const std::size_t words = std::size_t(2) * gpu::kSkyViewAngles * gpu::kSkyEdgeWords;
        edges_.write("edges of the sky view", bytesOf(std::vector<GLuint>(words)));
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, gpu::kSkyEdgesSlot, edges_.name());
        glBindTextureUnit(gpu::kSkyViewUnit, viewTable_.name());
        makeTable(edgesProgram_, "passes/sky_edges.comp", viewTable_,
                  {gpu::kSkyViewAzimuths, gpu::kSkyViewAngles, 2});
        // Read by the composite, written anew when the sun has moved.
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    }
}

void SkyPass::beginEdgeTiles(const FramePlan& plan) {
    gpu::SkyEdgeHead head{};
    head.groupsY = 1;
    head.groupsZ = 1;
    std::vector<GLuint> words(sizeof head / sizeof(GLuint) +
                              std::size_t(2) * workGroups(plan.settings.width, gpu::kSkyGroup) *
                                  workGroups(plan.settings.height, gpu::kSkyGroup));
    std::memcpy(words.data(), &head, sizeof head);
    edgeTiles_.write("tiles at edges of the sky", bytesOf(words));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, gpu::kSkyEdgesSlot, edges_.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, gpu::kSkyEdgeTilesSlot, edgeTiles_.name());
}

void SkyPass::drawEdgeTiles() {
    if (!edgeTilesProgram_) {
        edgeTilesProgram_ = Program({"passes/sky_edge_tiles.comp"}, defines_);
    }
    glUseProgram(edgeTilesProgram_.name());
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT |
                    GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, edgeTiles_.name());
    glDispatchComputeIndirect(0);
    ++glCounters().drawCalls;
}

void SkyPass::draw(const SkyWork& work, const FramePlan& plan, const FrameTargets& targets) {
    if (baseline_) {
        baseline_->bind();
    } else {
        textures_.bind();
    }
    if (work.makeView) {
        makeViewTable(work);
    }
    if (work.makeAerial) {
        if (!aerialTable_) {
            aerialTable_ = table("aerial perspective",
                                 {gpu::kAerialAcross, gpu::kAerialDown, 2 * gpu::kAerialDepths, 1});
        }
        makeTable(aerial_, "passes/sky_aerial.comp", aerialTable_,
                  {gpu::kAerialAcross, gpu::kAerialDown, gpu::kAerialDepths});
    }
    const int phase = int(plan.settings.haze.phase.kind);
    Program& composite = composite_[{phase, work.edges}];
    if (!composite) {
        std::vector<std::string> defines = defines_;
        defines.push_back("PHASE_KIND " + std::to_string(phase));
        if (work.edges) {
            defines.emplace_back("SKY_EDGES");
        }
        composite = Program({"passes/sky_composite.comp"}, defines);
    }
    if (work.edges) {
        beginEdgeTiles(plan);
    }
    glUseProgram(composite.name());
    glBindTextureUnit(gpu::kDepthUnit, targets.depth.name());
    glBindTextureUnit(gpu::kSkyViewUnit, viewTable_.name());
    glBindTextureUnit(gpu::kAerialUnit, aerialTable_.name());
    glBindImageTexture(gpu::kColorUnit, targets.color.name(), 0, GL_FALSE, 0, GL_READ_WRITE,
                       GL_RGBA32F);
    // What surfaces wrote is read as an image.
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    glDispatchCompute(workGroups(plan.settings.width, gpu::kSkyGroup),
                      workGroups(plan.settings.height, gpu::kSkyGroup), 1);
    ++glCounters().drawCalls;
    if (work.edges) {
        drawEdgeTiles();
    }
    glMemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                    GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                    GL_BUFFER_UPDATE_BARRIER_BIT);
}

}  // namespace ribalta
