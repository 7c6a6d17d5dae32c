// Single scattering out of spot beams, lamp by lamp, adaptively along the ray.
#include "reference/integrate_beams.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "base/check.h"
#include "optics/shader_lib.h"
#include "reference/light_map_texture.h"

namespace ribalta {
namespace {

/// Where a ray without end is cut, metres; what lies beyond holds less than 1e-8 of a beam that is
/// nearer than 10 m to the ray.
constexpr double kEndlessMetres = 1e9;
constexpr double kNoFarPlane = 1e30;

int phaseKind(PhaseFunction::Kind kind) {
    switch (kind) {
        case PhaseFunction::Kind::kGibbons:
            return shader::kPhaseGibbons;
        case PhaseFunction::Kind::kIsotropic:
            return shader::kPhaseIsotropic;
        case PhaseFunction::Kind::kHenyeyGreenstein:
            return shader::kPhaseHenyeyGreenstein;
        case PhaseFunction::Kind::kCornetteShanks:
            return shader::kPhaseCornetteShanks;
        case PhaseFunction::Kind::kRayleigh:
            return shader::kPhaseRayleigh;
    }
    checkFailed("a known PhaseFunction::Kind", __FILE__, __LINE__);
}

struct Interval {
    double first;
    double last;
};

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

struct BeamIntegrator::Lamp {
    SpotLight light;
    glm::dvec3 candela{0.0};
    double cosInner = 1.0;
    double cosOuter = 0.0;
    double sinOuter = 1.0;
    double inverseRange = 0.0;
    double cosRotation = 1.0;
    double sinRotation = 0.0;
    const LightMapTexture* lightMap = nullptr;

    /// Beam coordinates: x to the lamp's right, y up, z the way it shines.
    glm::dvec3 toBeam(const glm::dvec3& worldVector) const {
        return {glm::dot(worldVector, light.frame.right()), glm::dot(worldVector, light.frame.up()),
                glm::dot(worldVector, light.frame.forward())};
    }

    std::optional<Interval> clip(const glm::dvec3& origin, const glm::dvec3& direction,
                                 const Interval& interval) const;
    std::vector<double> kinks(const glm::dvec3& origin, const glm::dvec3& direction,
                              const Interval& interval) const;
    glm::dvec3 intensity(const glm::dvec3& point, double distance) const;
};

struct BeamIntegrator::State {
    std::vector<Lamp> lamps;
    std::vector<std::unique_ptr<LightMapTexture>> lightMaps;  // by image; null where no lamp asks
    Haze haze;
    LampVisibility isVisible;
    IntegralAccuracy accuracy;

    Integral alongLamp(const Lamp& lamp, const BeamRay& ray) const;
};

/// The part of the ray, in beam coordinates, that lies in the beam.
std::optional<Interval> BeamIntegrator::Lamp::clip(const glm::dvec3& origin,
                                                   const glm::dvec3& direction,
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

/// Where the cone's falloff reaches 1 along the ray, ascending.
std::vector<double> BeamIntegrator::Lamp::kinks(const glm::dvec3& origin,
                                                const glm::dvec3& direction,
                                                const Interval& interval) const {
    // coneFalloff takes the cosines to be at least 0.001 apart.
    const double cosFull = std::max(cosInner, cosOuter + 0.001);
    Interval full{};
    if (light.beamShape != BeamShape::kCone || cosFull >= 1.0 ||
        !shader::clipToCone(origin, direction, cosFull * cosFull, 1.0 - cosFull * cosFull,
                            shader::kLensMetres, kNoFarPlane, interval.first, interval.last,
                            full.first, full.last)) {
        return {};
    }
    return {full.first, full.last};
}

/// Candela per channel towards a point in beam coordinates, `distance` metres away.
glm::dvec3 BeamIntegrator::Lamp::intensity(const glm::dvec3& point, double distance) const {
    glm::dvec3 value = candela * shader::rangeWindow(distance, inverseRange);
    if (light.beamShape == BeamShape::kCone) {
        value *= shader::coneFalloff(point.z / distance, cosInner, cosOuter);
    }
    if (lightMap != nullptr) {
        const glm::dvec2 slope(point.x / point.z, point.y / point.z);
        value *=
            lightMap->at(shader::lightMapUv(slope, cosOuter / sinOuter, cosRotation, sinRotation));
    }
    return value;
}

Integral BeamIntegrator::State::alongLamp(const Lamp& lamp, const BeamRay& ray) const {
    const glm::dvec3 origin = lamp.toBeam(ray.origin - lamp.light.frame.position);
    const glm::dvec3 direction = lamp.toBeam(ray.direction);
    const std::optional<Interval> part =
        lamp.clip(origin, direction, {ray.first, std::min(ray.last, kEndlessMetres)});
    if (!part) {
        return {};
    }
    // Projective placement takes the inverse square out of the integrand. t of [a, b] from x of [0,
    // 1]:
    const double length = part->last - part->first;
    const double z0 = origin.z + part->first * direction.z;
    const double z1 = origin.z + part->last * direction.z;
    const auto distanceAt = [&](double x) {
        return part->first + length * shader::projectiveStep(x, z0, z1);
    };
    const int kind = phaseKind(haze.phase.kind);
    const std::function<glm::dvec3(double)> integrand = [&](double x) {
        const double t = distanceAt(x);
        const glm::dvec3 point = origin + t * direction;
        const double r = glm::length(point);
        const double phase = shader::phaseFunction(kind, shader::scatteringCosine(point, direction),
                                                   haze.phase.g, haze.phase.k);
        return lamp.intensity(point, r) *
               (shader::scatteredIntensity(phase, haze.scatteringPerMetre,
                                           haze.extinctionPerMetre(), r, t) *
                length * shader::projectiveWeight(x, z0, z1));
    };
    std::function<bool(double)> lit;
    if (isVisible) {
        lit = [&](double x) {
            return isVisible(lamp.light, ray.origin + distanceAt(x) * ray.direction);
        };
    }
    std::vector<double> ends = {0.0};
    for (const double t : lamp.kinks(origin, direction, *part)) {
        // The inverse of projectiveStep.
        const double f = (t - part->first) / length;
        ends.push_back(glm::clamp(f * z1 / (z0 * (1.0 - f) + f * z1), ends.back(), 1.0));
    }
    ends.push_back(1.0);
    return integrateLit(integrand, lit, ends, accuracy);
}

BeamIntegrator::BeamIntegrator(std::span<const SpotLight> lamps, std::span<const Image> images,
                               const Haze& haze, LampVisibility isVisible,
                               const IntegralAccuracy& accuracy)
    : state_(std::make_unique<State>()) {
    state_->haze = haze;
    state_->isVisible = std::move(isVisible);
    state_->accuracy = accuracy;
    state_->lightMaps.resize(images.size());
    for (const SpotLight& light : lamps) {
        Lamp lamp;
        lamp.light = light;
        lamp.candela = glm::dvec3(light.color) * light.intensityCandela;
        const double outer = glm::clamp(light.outerConeAngle, kMinConeAngle, kMaxConeAngle);
        lamp.cosInner = std::cos(glm::clamp(light.innerConeAngle, 0.0, outer));
        lamp.cosOuter = std::cos(outer);
        lamp.sinOuter = std::sin(outer);
        lamp.inverseRange = 1.0 / light.rangeMetres;
        if (light.lightMap) {
            CHECK(light.lightMap->image >= 0 && std::size_t(light.lightMap->image) < images.size());
            const auto index = std::size_t(light.lightMap->image);
            std::unique_ptr<LightMapTexture>& texture = state_->lightMaps[index];
            if (!texture) {
                texture = std::make_unique<LightMapTexture>(images[index]);
            }
            lamp.lightMap = texture.get();
            lamp.cosRotation = std::cos(light.lightMap->rotationRadians);
            lamp.sinRotation = std::sin(light.lightMap->rotationRadians);
        }
        state_->lamps.push_back(std::move(lamp));
    }
}

BeamIntegrator::~BeamIntegrator() = default;
BeamIntegrator::BeamIntegrator(BeamIntegrator&&) noexcept = default;
BeamIntegrator& BeamIntegrator::operator=(BeamIntegrator&&) noexcept = default;

Integral BeamIntegrator::along(const BeamRay& ray) const {
    Integral total;
    for (const Lamp& lamp : state_->lamps) {
        const Integral one = state_->alongLamp(lamp, ray);
        total.value += one.value;
        total.error += one.error;
        total.evaluations += one.evaluations;
    }
    return total;
}

}  // namespace ribalta
