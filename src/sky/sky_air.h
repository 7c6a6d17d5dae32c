// An atmosphere as the shaders' library takes it, in double precision. As with
// optics/shader_lib.h: for .cpp files only, each has its own.
#pragma once

#include "optics/shader_lib.h"
#include "scene/atmosphere.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"

namespace ribalta {
namespace {

shader::Air airOf(const Atmosphere& atmosphere) {
    shader::Air air;
    air.groundRadius = atmosphere.groundRadiusMetres;
    air.top = atmosphere.topMetres;
    air.rayleighHeight = atmosphere.rayleighScaleHeightMetres;
    air.mieHeight = atmosphere.mieScaleHeightMetres;
    air.rayleighScattering = atmosphere.rayleighScatteringPerMetre;
    air.mieScattering = atmosphere.mieScatteringPerMetre;
    air.mieExtinction = atmosphere.mieExtinctionPerMetre;
    air.mieG = atmosphere.mieG;
    return air;
}

}  // namespace
}  // namespace ribalta

#pragma GCC diagnostic pop
