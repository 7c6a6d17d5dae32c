#include "render/beam_program.h"

namespace ribalta {

std::vector<std::string> beamDefines(const BeamsWork& work) {
    std::vector<std::string> defines = {"PHASE_KIND " + std::to_string(int(work.phase))};
    if (work.separateOutput) {
        defines.emplace_back("BEAMS_OUTPUT");
    }
    if (work.lightMaps) {
        defines.emplace_back("LIGHT_MAPS");
    }
    if (work.shadowPyramid) {
        defines.emplace_back("SHADOW_RUNS");
        if (work.countRuns) {
            defines.emplace_back("COUNT_RUNS");
        }
    }
    return defines;
}

gpu::BeamSettings describeBeams(const BeamsWork& work) {
    gpu::BeamSettings settings{};
    settings.planes =
        glm::vec4(work.settings.planes, work.firstDepth, work.spacingMetres, work.spacingMetres);
    settings.lattice = glm::ivec4(work.latticePoints, work.tiles.tiles.size(), 0);
    settings.adaptive = glm::vec4(work.settings.usedTolerance(), 0.0, 0.0, 0.0);
    settings.cells = glm::ivec4(work.settings.cellsAcross, work.settings.cellsDown, 0, 0);
    return settings;
}

}  // namespace ribalta
