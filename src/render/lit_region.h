// LitRegion: where a light map lets light through. A lamp whose light map has a black rim shines
// into a narrower beam than its cone; one whose light map is all black is dark.
#pragma once

#include <map>

#include <glm/glm.hpp>

#include "image/image.h"
#include "scene/scene.h"

namespace ribalta {

/// Encloses every point that light can come through, with room for the filtering of texels.
/// Coordinates are half sides of the picture from its middle, x right and y up.
struct LitRegion {
    bool isDark = false;  ///< no texel lets light through
    glm::dvec2 low{-1.0};
    glm::dvec2 high{1.0};
    double radius = 1.5;  ///< of a circle around the middle, 0..1.5
};

LitRegion litRegion(const Image& lightMap);

/// By image. A light map that is not in it counts as lit all over.
using LitRegions = std::map<int, LitRegion>;

/// Of all light maps of the scene's lamps. Reads every texel.
LitRegions litRegions(const Scene& scene);
/// Those that are not there yet; a scene's lamps may be given others.
void addLitRegions(const Scene& scene, LitRegions& regions);

/// The lamp as far as its light goes: its outer cone angle narrowed to what its light map lets
/// through, its intensity 0 where that is nothing. For telling what the lamp reaches, where its
/// beam lies in the picture and what may cast a shadow in it; what is drawn is the lamp itself, so
/// that the picture stays what it is.
SpotLight litPart(const SpotLight& lamp, const LitRegions& regions);

}  // namespace ribalta
