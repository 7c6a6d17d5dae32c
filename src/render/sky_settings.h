// SkyDrawing: which sky a frame has.
#pragma once

#include <glm/glm.hpp>

#include "scene/atmosphere.h"
#include "sky/sky_tables.h"

namespace ribalta {

struct SkyDrawing {
    Atmosphere air;
    SkyOrders orders;
    glm::dvec3 towardsSun{0.0, 1.0, 0.0};  ///< unit, world
    double altitudeMetres = 0.0;           ///< of the scene's origin above the ground, >= 0
    int sunLamp = -1;  ///< into Scene::directionalLights: the lamp that the sun takes the place of

    bool operator==(const SkyDrawing&) const = default;
};

}  // namespace ribalta
