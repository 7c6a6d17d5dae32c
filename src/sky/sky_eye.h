// SkyEye: where a point of a scene is in a planet's air.
#pragma once

#include <glm/glm.hpp>

#include "scene/atmosphere.h"

namespace ribalta {

/// The scene's origin lies some metres above the ground, its +Y there being the zenith; the planet
/// curves away under it.
struct SkyEye {
    double heightMetres = 0.0;  ///< above the ground, not below it
    glm::dvec3 zenith{0.0, 1.0, 0.0};
    double muS = 1.0;  ///< cosine between sun and zenith
    double belowMetres =
        0.0;  ///< how far below the ground the eye stands; it looks from the ground

    bool operator==(const SkyEye&) const = default;
};

/// Whether a ray from there may run through the planet's shadow before it leaves the air: not where
/// the sun stands over the ground's horizon in all directions that it is seen in.
bool seesPlanetShadow(const Atmosphere& air, const SkyEye& eye);

/// `altitudeMetres`: of the origin; `towardsSun`: unit, world.
SkyEye skyEye(const Atmosphere& air, double altitudeMetres, const glm::dvec3& towardsSun,
              const glm::dvec3& position);

}  // namespace ribalta
