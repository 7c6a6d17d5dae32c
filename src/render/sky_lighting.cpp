#include "render/sky_lighting.h"

namespace ribalta {

SkyLighting skyLighting(const SkyDrawing& sky, const SkyTables& tables) {
    return skyLighting(sky, tables.sunlight(sky.altitudeMetres, sky.towardsSun.y),
                       tables.irradianceAt(sky.altitudeMetres, sky.towardsSun.y));
}

SkyLighting skyLighting(const SkyDrawing& sky, const glm::dvec3& sunlight,
                        const SkyIrradiance& irradiance) {
    SkyLighting light;
    light.towardsSun = sky.towardsSun;
    const glm::dvec3 level(sky.towardsSun.x, 0.0, sky.towardsSun.z);
    // Under a sun at the zenith all sides are the same.
    light.sunward = glm::length(level) > 1e-9 ? glm::normalize(level) : light.sunward;
    const glm::dvec3 sun = sky.air.sunIlluminanceLux;
    light.sunLux = sun * sunlight;
    light.lux = irradiance;
    for (glm::dvec3* side : {&light.lux.up, &light.lux.down, &light.lux.towardsSun,
                             &light.lux.awayFromSun, &light.lux.across}) {
        *side *= sun;
    }
    return light;
}

}  // namespace ribalta
