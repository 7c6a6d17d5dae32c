// BeamLamp: one spot's beam in double precision; BeamSegment: the part of a view ray that lies in
// it. Neither knows what blocks light.
#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "reference/interval.h"
#include "reference/light_map_pyramid.h"
#include "scene/light.h"

namespace ribalta {

/// A spot with its numbers worked out. Cone angles are kept within kMinConeAngle and kMaxConeAngle.
/// Beam coordinates: apex at 0, x to the lamp's right, y up, z the depth along the beam, metres.
struct BeamLamp {
    /// `lightMap` is the lamp's, null where it has none; it must outlive this.
    BeamLamp(const SpotLight& spot, int spotIndex, const LightMapPyramid* itsLightMap);

    SpotLight light;
    int index = 0;  ///< into the lamps it was made from
    glm::dvec3 candela{0.0};
    double cosInner = 1.0;
    double cosOuter = 0.0;
    double sinOuter = 1.0;
    double inverseRange = 0.0;  ///< 1/m
    double cosRotation = 1.0;
    double sinRotation = 0.0;
    const LightMapPyramid* lightMap = nullptr;

    bool isDark() const;
    /// A direction, or a point less the lamp's position, from the world into beam coordinates.
    glm::dvec3 toBeam(const glm::dvec3& worldVector) const;
    /// The part of a ray (beam coordinates) in the beam, before the lens plane and within range.
    std::optional<Interval> clip(const glm::dvec3& origin, const glm::dvec3& direction,
                                 const Interval& interval) const;
    /// The part of a ray where the cone's falloff is 1; its ends are kinks.
    std::optional<Interval> fullCone(const glm::dvec3& origin, const glm::dvec3& direction,
                                     const Interval& interval) const;
    glm::dvec2 lightMapUv(const glm::dvec2& slope) const;
    /// Texels of the light map, its longer side, that a unit of slope spans.
    double lightMapTexels() const { return 0.5 * lightMap->side() * cosOuter / sinOuter; }
};

/// Placed projectively: x of [0, 1] runs over the part with 1 / z even, which takes the inverse
/// square out of the integrand and makes slopes (x / z, y / z) and 1 / z linear in x.
struct BeamSegment {
    const BeamLamp& lamp;
    glm::dvec3 worldOrigin;     ///< of the ray, less the lamp's position
    glm::dvec3 worldDirection;  ///< unit
    glm::dvec3 origin;          ///< the same in beam coordinates
    glm::dvec3 direction;
    Interval part;  ///< metres along the ray
    double z0;      ///< depth along the beam at the part's ends, > 0
    double z1;
    glm::dvec2 slope0;
    glm::dvec2 slope1;

    /// Nothing where the ray (world, unit direction) misses the beam within `interval`.
    static std::optional<BeamSegment> make(const BeamLamp& lamp, const glm::dvec3& rayOrigin,
                                           const glm::dvec3& rayDirection,
                                           const Interval& interval);

    /// Metres along the ray at x.
    double distanceAt(double x) const;
    /// The inverse of distanceAt, kept within 0..1.
    double placeOf(double t) const;
};

}  // namespace ribalta
