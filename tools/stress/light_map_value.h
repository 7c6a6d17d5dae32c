// Light maps in double precision, and how much they change within a distance.
#pragma once

#include <glm/glm.hpp>

namespace ribalta::stress {

/// Linear R, G, B of light map `index` of lightMaps() at uv (origin top left), bilinear between the
/// texels' centres, the edge continued.
glm::dvec3 lightMapValue(int index, const glm::dvec2& uv);

/// The largest difference of a channel between texels of map `index` up to `texels` apart.
double lightMapChange(int index, double texels);

int lightMapSide();

}  // namespace ribalta::stress
