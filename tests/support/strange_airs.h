// Atmospheres at the ends of what a sky has to draw.
#pragma once

#include <vector>

#include "scene/atmosphere.h"

namespace ribalta::test {

/// Earth's air with fifty times the haze; on a planet of 400 km; and with both of its parts 100 m
/// and 50 km high.
inline std::vector<Atmosphere> strangeAirs() {
    Atmosphere thick;
    thick.mieScatteringPerMetre *= 50.0;
    thick.mieExtinctionPerMetre *= 50.0;
    Atmosphere tiny;
    tiny.groundRadiusMetres = 400e3;
    Atmosphere shallow;
    shallow.rayleighScaleHeightMetres = 100.0;
    shallow.mieScaleHeightMetres = 100.0;
    Atmosphere deep;
    deep.rayleighScaleHeightMetres = 50e3;
    deep.mieScaleHeightMetres = 50e3;
    return {thick, tiny, shallow, deep};
}

}  // namespace ribalta::test
