// A photometric web as what a spot projects: a cone, candela and a light map. No files, no glTF.
#pragma once

#include "gltf/photometric_web.h"
#include "image/image.h"

namespace ribalta::gltf {

struct ProjectedWeb {
    double halfAngle = 0.0;  ///< radians, 5 degrees to kMaxConeAngle
    double candela = 0.0;    ///< the most within the cone; 0 where there is no light in it
    double lostShare = 0.0;  ///< 0..1: of all its lumens, those that it sends past the cone
    Image lightMap;          ///< linear, 0..1 of `candela`; fits a cone as scene/light.h says
};

/// The narrowest cone that holds all but a thousandth of the brightest light, as far as a spot can
/// be drawn.
ProjectedWeb projectWeb(const PhotometricWeb& web);

/// Pixels a side of the light map.
inline constexpr int kWebMapSide = 512;

}  // namespace ribalta::gltf
