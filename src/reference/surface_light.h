// Surface light: what a point of a surface sends towards the eye under all lamps, in double
// precision, as shaders/passes/forward.frag has it; with hard shadows, and textures at full
// size.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "reference/beam_lamp.h"
#include "reference/cast_rays.h"
#include "reference/material_textures.h"
#include "reference/placed_surface.h"
#include "reference/sky_daylight.h"
#include "scene/haze.h"
#include "scene/scene.h"

namespace ribalta {

/// What a point of a surface with MaterialLayers has besides, textures applied.
struct PointLayers {
    glm::dvec3 dielectricF0{0.04};  ///< straight on
    double specular = 1.0;
    double coat = 0.0;
    double coatRoughness = 0.0;
    glm::dvec3 sheenColor{0.0};
    double sheenRoughness = 0.0;
    double anisotropy = 0.0;
    double transmission = 0.0;
    glm::dvec3 tangent{0.0};  ///< of anisotropy
    glm::dvec3 bitangent{0.0};
    glm::dvec3 coatNormal{0.0};
};

/// A point of a surface with all that its light depends on.
struct ShadedPoint {
    glm::dvec3 position{0.0};  ///< world, metres
    glm::dvec3 towardsEye{0.0};
    glm::dvec3 normal{0.0};     ///< shading
    glm::dvec3 geometric{0.0};  ///< of the triangle, towards the eye
    glm::dvec3 baseColor{0.0};
    double alpha = 1.0;
    double metallic = 0.0;
    double roughness = 1.0;
    double occlusion = 1.0;
    glm::dvec3 emission{0.0};  ///< cd/m2
    bool unlit = false;
    std::optional<PointLayers> layers;
    /// What the next pixel to the right and the next one up see of the surface's plane, less
    /// position; zero: the pixel sees a point.
    glm::dvec3 acrossPixel{0.0};
    glm::dvec3 upPixel{0.0};
};

/// Reads a surface's material where it was hit by a ray of that unit direction from `origin`.
ShadedPoint shadedPoint(const PlacedSurface& surface, const MaterialTextures& textures,
                        const SurfaceHit& hit, const glm::dvec3& origin,
                        const glm::dvec3& direction);

/// What light from straight behind a point keeps on its way to the eye, by channel, its alpha
/// included.
glm::dvec3 keptBehind(const ShadedPoint& point);

class SurfaceLight {
  public:
    /// Keeps references to all but the haze. `day`: sun and sky, whose sun takes its lamp's
    /// place and casts shadows as soft as its disc makes them; null where there is no sky.
    SurfaceLight(const Scene& scene, std::span<const BeamLamp> spots, const RayCaster& caster,
                 const Haze& haze, double ambientLux, const SkyDaylight* day = nullptr);

    /// cd/m2 at the surface, before the haze between it and the eye.
    glm::dvec3 radiance(const ShadedPoint& point) const;

  private:
    glm::dvec3 fromSpot(const BeamLamp& lamp, const ShadedPoint& point) const;
    glm::dvec3 fromDay(const ShadedPoint& point) const;
    /// 0..1: of its disc.
    double sunSeen(const ShadedPoint& point) const;
    glm::dvec3 fromPoint(const PointLight& lamp, const ShadedPoint& point) const;
    bool isShadowed(const BeamLamp& lamp, const ShadedPoint& point, double depth) const;

    const Scene& scene_;
    std::span<const BeamLamp> spots_;
    const RayCaster& caster_;
    double extinction_;
    double ambientLux_;
    const SkyDaylight* daylight_;
};

}  // namespace ribalta
