#include "haze_options.h"

#include <CLI/CLI.hpp>

#include "options.h"

namespace ribalta {

void HazeOptions::addTo(CLI::App& command) {
    command
        .add_option("--haze", haze,
                    "SCATTERING[,ABSORPTION] of the haze in 1/m; 0 is clear air without beams "
                    "(default: 0.02)")
        ->type_name("S[,A]");
    command
        .add_option("--phase", phase,
                    "phase function of the haze: gibbons, isotropic, rayleigh, hg:G, "
                    "cornette-shanks:G, with -1 < G < 1 (default: gibbons)")
        ->type_name("NAME[:G]");
    command
        .add_option("--K", k,
                    "factor of Gibbons' phase function (default: 1/(8 pi), which is physical)")
        ->type_name("NUMBER")
        ->check(expectPositive, "");
}

Haze HazeOptions::parsed(const Haze& otherwise) const {
    Haze result = otherwise;
    if (haze) {
        parseHaze(*haze, result);
    }
    if (phase) {
        parsePhase(*phase, result.phase);
    }
    result.phase.k = k.value_or(result.phase.k);
    if (k && result.phase.kind != PhaseFunction::Kind::kGibbons) {
        throw CLI::ValidationError("--K", "belongs to --phase gibbons");
    }
    return result;
}

}  // namespace ribalta
