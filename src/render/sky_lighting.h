// SkyLighting: what sun and sky light a scene with.
#pragma once

#include <glm/glm.hpp>

#include "render/sky_settings.h"

namespace ribalta {

struct SkyLighting {
    glm::dvec3 towardsSun{0.0, 1.0, 0.0};  ///< unit, world
    glm::dvec3 sunward{1.0, 0.0, 0.0};     ///< the same made level
    glm::dvec3 sunLux{0.0};                ///< on a plane that faces it
    SkyIrradiance lux;                     ///< by sky and ground
};

/// Where the scene's origin stands, from what is there for a sun of irradiance 1.
SkyLighting skyLighting(const SkyDrawing& sky, const glm::dvec3& sunlight,
                        const SkyIrradiance& irradiance);
/// By the tables of the renderer's own model.
SkyLighting skyLighting(const SkyDrawing& sky, const SkyTables& tables);

}  // namespace ribalta
