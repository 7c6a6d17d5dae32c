// The integral of a smooth function times a light map along a straight line over the map.
#pragma once

#include <glm/glm.hpp>

#include "reference/light_map_texture.h"
#include "reference/smooth_panel.h"

namespace ribalta {

/// The integral over panel.place of the panel's polynomial times the map's R, G, B, whose texture
/// coordinates run evenly from `uvAt0` (x = 0) to `uvAt1` (x = 1). Cell by cell of the bilinear
/// filter, so that no kink is integrated over; off by less than about `relative` of the panel's
/// largest value times the map's integral.
glm::dvec3 integrateOverLightMap(const SmoothPanel& panel, const LightMapTexture& map,
                                 const glm::dvec2& uvAt0, const glm::dvec2& uvAt1, double relative);

}  // namespace ribalta
