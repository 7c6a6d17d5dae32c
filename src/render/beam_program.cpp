#include "render/beam_program.h"

#include "optics/shader_lib.h"

namespace ribalta {

int shaderPhase(PhaseFunction::Kind kind) {
    switch (kind) {
        case PhaseFunction::Kind::kGibbons:
            return shader::kPhaseGibbons;
        case PhaseFunction::Kind::kIsotropic:
            return shader::kPhaseIsotropic;
        case PhaseFunction::Kind::kHenyeyGreenstein:
            return shader::kPhaseHenyeyGreenstein;
        case PhaseFunction::Kind::kCornetteShanks:
            return shader::kPhaseCornetteShanks;
        case PhaseFunction::Kind::kRayleigh:
            return shader::kPhaseRayleigh;
    }
    return shader::kPhaseIsotropic;
}

std::vector<std::string> beamDefines(const BeamsWork& work) {
    std::vector<std::string> defines = {"PHASE_KIND " + std::to_string(shaderPhase(work.phase))};
    if (work.separateOutput) {
        defines.emplace_back("BEAMS_OUTPUT");
    }
    return defines;
}

gpu::BeamSettings describeBeams(const BeamsWork& work) {
    gpu::BeamSettings settings{};
    settings.planes =
        glm::vec4(work.settings.planes, work.firstDepth, work.spacingMetres, work.spacingMetres);
    settings.cells = glm::ivec4(work.settings.cellsAcross, work.settings.cellsDown, 0, 0);
    return settings;
}

}  // namespace ribalta
