#include "haze_options.h"

#include <CLI/CLI.hpp>

#include "options.h"

namespace ribalta {

void HazeOptions::addTo(CLI::App& command) {
    command
        .add_option("--haze", haze,
                    "SCATTERING[,ABSORPTION] of the haze in 1/m; 0 is clear air without beams")
        ->type_name("S[,A]")
        ->capture_default_str();
    command
        .add_option("--phase", phase,
                    "phase function of the haze: gibbons, isotropic, rayleigh, hg:G, "
                    "cornette-shanks:G, with -1 < G < 1")
        ->type_name("NAME[:G]")
        ->capture_default_str();
    command
        .add_option("--K", k,
                    "factor of Gibbons' phase function (default: 1/(8 pi), which is physical)")
        ->type_name("NUMBER")
        ->check(expectPositive, "");
}

Haze HazeOptions::parsed() const {
    Haze result;
    parseHaze(haze, result);
    parsePhase(phase, result.phase);
    result.phase.k = k.value_or(result.phase.k);
    if (k && result.phase.kind != PhaseFunction::Kind::kGibbons) {
        throw CLI::ValidationError("--K", "belongs to --phase gibbons");
    }
    return result;
}

}  // namespace ribalta
