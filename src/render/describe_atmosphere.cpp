#include "render/describe_atmosphere.h"

namespace ribalta {

gpu::Atmosphere describeAtmosphere(const Atmosphere& atmosphere) {
    gpu::Atmosphere result{};
    result.rayleigh =
        glm::vec4(atmosphere.rayleighScatteringPerMetre, atmosphere.rayleighScaleHeightMetres);
    result.mieScattering =
        glm::vec4(atmosphere.mieScatteringPerMetre, atmosphere.mieScaleHeightMetres);
    result.mieExtinction = glm::vec4(atmosphere.mieExtinctionPerMetre, atmosphere.mieG);
    result.shell = glm::vec4(atmosphere.groundRadiusMetres, atmosphere.topMetres, 0.0, 0.0);
    result.albedo = glm::vec4(atmosphere.groundAlbedo, 0.0);
    result.sun = glm::vec4(atmosphere.sunIlluminanceLux, atmosphere.sunAngularRadius);
    return result;
}

}  // namespace ribalta
