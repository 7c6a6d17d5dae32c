#include "render/passes/beams_clipped.h"

#include "render/beam_program.h"

namespace ribalta {

void ClippedBeamsPass::draw(const BeamsWork& work, const GpuScene& gpuScene,
                            const ShadowTextures& shadows, const FrameTargets& targets) {
    Program& program = programs_[{work.settings.method, beamDefines(work)}];
    if (!program) {
        std::vector<std::string> defines = beamDefines(work);
        if (work.settings.method == BeamMethod::kMarch) {
            defines.emplace_back("EVEN_STEPS");
        }
        program = Program({"passes/beams_tiles.vert", "passes/beams_clipped.frag"}, defines);
    }
    inputs_.bind(work, gpuScene, shadows, targets);
    targets.haze.bind();
    inputs_.drawTiles(program, Blend::kAdd);
    inputs_.unbind();
}

}  // namespace ribalta
