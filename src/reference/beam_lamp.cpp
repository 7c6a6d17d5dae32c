#include "reference/beam_lamp.h"

#include <algorithm>
#include <cmath>

#include "optics/shader_lib.h"

namespace ribalta {
namespace {

constexpr double kNoFarPlane = 1e30;

/// The part of a ray (unit direction, seen from the lamp) that is within `range` of the lamp.
std::optional<Interval> clipToSphere(const glm::dvec3& origin, const glm::dvec3& direction,
                                     double range, const Interval& interval) {
    const double nearest = -glm::dot(origin, direction);
    const double h = glm::length(glm::cross(origin, direction));
    if (!(h < range)) {
        return std::nullopt;
    }
    const double half = std::sqrt((range - h) * (range + h));
    const Interval part{std::max(interval.first, nearest - half),
                        std::min(interval.last, nearest + half)};
    return part.first < part.last ? std::optional(part) : std::nullopt;
}

}  // namespace

BeamLamp::BeamLamp(const SpotLight& spot, int spotIndex, const LightMapPyramid* itsLightMap)
    : light(spot),
      index(spotIndex),
      candela(spot.shown ? glm::dvec3(spot.color) * spot.intensityCandela : glm::dvec3(0.0)),
      inverseRange(1.0 / spot.rangeMetres),
      lightMap(itsLightMap) {
    const double outer = glm::clamp(light.outerConeAngle, kMinConeAngle, kMaxConeAngle);
    cosInner = std::cos(glm::clamp(light.innerConeAngle, 0.0, outer));
    cosOuter = std::cos(outer);
    sinOuter = std::sin(outer);
    if (light.lightMap) {
        cosRotation = std::cos(light.lightMap->rotationRadians);
        sinRotation = std::sin(light.lightMap->rotationRadians);
    }
}

bool BeamLamp::isDark() const {
    return !(std::max({candela.x, candela.y, candela.z}) > 0.0) || !(light.rangeMetres > 0.0);
}

glm::dvec3 BeamLamp::toBeam(const glm::dvec3& worldVector) const {
    return {glm::dot(worldVector, light.frame.right()), glm::dot(worldVector, light.frame.up()),
            glm::dot(worldVector, light.frame.forward())};
}

std::optional<Interval> BeamLamp::clip(const glm::dvec3& origin, const glm::dvec3& direction,
                                       const Interval& interval) const {
    Interval part{};
    const bool hit = light.beamShape == BeamShape::kCone
                         ? shader::clipToCone(origin, direction, cosOuter * cosOuter,
                                              sinOuter * sinOuter, shader::kLensMetres, kNoFarPlane,
                                              interval.first, interval.last, part.first, part.last)
                         : shader::clipToPyramid(origin, direction, sinOuter / cosOuter,
                                                 shader::kLensMetres, kNoFarPlane, interval.first,
                                                 interval.last, part.first, part.last);
    if (!hit) {
        return std::nullopt;
    }
    return inverseRange > 0.0 ? clipToSphere(origin, direction, 1.0 / inverseRange, part) : part;
}

std::optional<Interval> BeamLamp::fullCone(const glm::dvec3& origin, const glm::dvec3& direction,
                                           const Interval& interval) const {
    // coneFalloff takes the cosines to be at least 0.001 apart.
    const double cosFull = std::max(cosInner, cosOuter + 0.001);
    Interval full{};
    if (light.beamShape != BeamShape::kCone || cosFull >= 1.0 ||
        !shader::clipToCone(origin, direction, cosFull * cosFull, 1.0 - cosFull * cosFull,
                            shader::kLensMetres, kNoFarPlane, interval.first, interval.last,
                            full.first, full.last)) {
        return std::nullopt;
    }
    return full;
}

glm::dvec2 BeamLamp::lightMapUv(const glm::dvec2& slope) const {
    return shader::lightMapUv(slope, cosOuter / sinOuter, cosRotation, sinRotation);
}

std::optional<BeamSegment> BeamSegment::make(const BeamLamp& lamp, const glm::dvec3& rayOrigin,
                                             const glm::dvec3& rayDirection,
                                             const Interval& interval) {
    const glm::dvec3 worldOrigin = rayOrigin - lamp.light.frame.position;
    const glm::dvec3 origin = lamp.toBeam(worldOrigin);
    const glm::dvec3 direction = lamp.toBeam(rayDirection);
    const std::optional<Interval> part = lamp.clip(origin, direction, interval);
    if (!part) {
        return std::nullopt;
    }
    const glm::dvec3 first = origin + part->first * direction;
    const glm::dvec3 last = origin + part->last * direction;
    // The lens plane lies at kLensMetres; rounding of a far ray may put an end a little before it.
    const double z0 = std::max(first.z, 0.5 * shader::kLensMetres);
    const double z1 = std::max(last.z, 0.5 * shader::kLensMetres);
    return BeamSegment{lamp,
                       worldOrigin,
                       rayDirection,
                       origin,
                       direction,
                       *part,
                       z0,
                       z1,
                       glm::dvec2(first) / z0,
                       glm::dvec2(last) / z1};
}

double BeamSegment::distanceAt(double x) const {
    return part.first + part.length() * shader::projectiveStep(x, z0, z1);
}

double BeamSegment::placeOf(double t) const {
    const double f = (t - part.first) / part.length();
    return glm::clamp(f * z1 / (z0 * (1.0 - f) + f * z1), 0.0, 1.0);
}

}  // namespace ribalta
