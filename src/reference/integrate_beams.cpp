// Single scattering out of spot beams, lamp by lamp, adaptively along the ray.
#include "reference/integrate_beams.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "base/check.h"
#include "optics/shader_lib.h"
#include "reference/light_map_texture.h"
#include "reference/lit_stretches.h"

namespace ribalta {
namespace {

/// Where a ray without end is cut, metres; what lies beyond holds less than 1e-8 of a beam that is
/// nearer than 10 m to the ray.
constexpr double kEndlessMetres = 1e9;
constexpr double kNoFarPlane = 1e30;

static_assert(int(PhaseFunction::Kind::kGibbons) == shader::kPhaseGibbons &&
              int(PhaseFunction::Kind::kIsotropic) == shader::kPhaseIsotropic &&
              int(PhaseFunction::Kind::kHenyeyGreenstein) == shader::kPhaseHenyeyGreenstein &&
              int(PhaseFunction::Kind::kCornetteShanks) == shader::kPhaseCornetteShanks &&
              int(PhaseFunction::Kind::kRayleigh) == shader::kPhaseRayleigh);

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

/// The stretches with a cut at every place inside them; both ascending.
std::vector<Interval> cutAt(const std::vector<Interval>& stretches,
                            const std::vector<double>& places) {
    std::vector<Interval> pieces;
    auto place = places.begin();
    for (Interval rest : stretches) {
        for (; place != places.end() && *place < rest.last; ++place) {
            if (*place > rest.first) {
                pieces.push_back({rest.first, *place});
                rest.first = *place;
            }
        }
        pieces.push_back(rest);
    }
    return pieces;
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
    std::optional<Interval> fullCone(const glm::dvec3& origin, const glm::dvec3& direction,
                                     const Interval& interval) const;
    glm::dvec2 lightMapUv(const glm::dvec3& point) const;
    glm::dvec3 intensity(const glm::dvec3& point, double distance) const;
};

/// The part of one ray that lies in one lamp's beam, in beam coordinates, placed projectively: x of
/// [0, 1] runs over it with 1 / z even, which takes the inverse square out of the integrand and
/// makes light-map coordinates linear.
struct BeamIntegrator::Segment {
    const Lamp& lamp;
    glm::dvec3 origin;
    glm::dvec3 direction;
    Interval part;  ///< metres along the ray
    double z0 = 0.0;
    double z1 = 0.0;

    Segment(const Lamp& itsLamp, const glm::dvec3& itsOrigin, const glm::dvec3& itsDirection,
            const Interval& itsPart)
        : lamp(itsLamp),
          origin(itsOrigin),
          direction(itsDirection),
          part(itsPart),
          z0(origin.z + part.first * direction.z),
          z1(origin.z + part.last * direction.z) {}

    double distanceAt(double x) const {
        return part.first + part.length() * shader::projectiveStep(x, z0, z1);
    }
    /// The inverse of distanceAt.
    double placeOf(double t) const {
        const double f = (t - part.first) / part.length();
        return glm::clamp(f * z1 / (z0 * (1.0 - f) + f * z1), 0.0, 1.0);
    }

    glm::dvec3 integrand(double x, const Haze& haze) const;
    std::vector<double> kinks() const;
    std::vector<double> probes(int count) const;
};

struct BeamIntegrator::State {
    std::vector<Lamp> lamps;
    std::vector<std::unique_ptr<LightMapTexture>> lightMaps;  // by image; null where no lamp asks
    Haze haze;
    LampVisibility isVisible;
    BeamAccuracy accuracy;

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

/// The part of the ray where the cone's falloff is 1; its ends are kinks.
std::optional<Interval> BeamIntegrator::Lamp::fullCone(const glm::dvec3& origin,
                                                       const glm::dvec3& direction,
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

glm::dvec2 BeamIntegrator::Lamp::lightMapUv(const glm::dvec3& point) const {
    return shader::lightMapUv({point.x / point.z, point.y / point.z}, cosOuter / sinOuter,
                              cosRotation, sinRotation);
}

/// Candela per channel towards a point in beam coordinates, `distance` metres away.
glm::dvec3 BeamIntegrator::Lamp::intensity(const glm::dvec3& point, double distance) const {
    glm::dvec3 value = candela * shader::rangeWindow(distance, inverseRange);
    if (light.beamShape == BeamShape::kCone) {
        value *= shader::coneFalloff(point.z / distance, cosInner, cosOuter);
    }
    if (lightMap != nullptr) {
        value *= lightMap->at(lightMapUv(point));
    }
    return value;
}

glm::dvec3 BeamIntegrator::Segment::integrand(double x, const Haze& haze) const {
    const double t = distanceAt(x);
    const glm::dvec3 point = origin + t * direction;
    const double r = glm::length(point);
    const double phase = shader::phaseFunction(static_cast<int>(haze.phase.kind),
                                               shader::scatteringCosine(point, direction),
                                               haze.phase.g, haze.phase.k);
    return lamp.intensity(point, r) * (shader::scatteredIntensity(phase, haze.scatteringPerMetre,
                                                                  haze.extinctionPerMetre(), r, t) *
                                       part.length() * shader::projectiveWeight(x, z0, z1));
}

/// Every x where the integrand has a kink, ascending: the inner cone, and the centres of texels,
/// where a bilinear filter goes over to the next pair.
std::vector<double> BeamIntegrator::Segment::kinks() const {
    std::vector<double> places;
    if (const std::optional<Interval> full = lamp.fullCone(origin, direction, part)) {
        places = {placeOf(full->first), placeOf(full->last)};
    }
    if (lamp.lightMap != nullptr) {
        const glm::dvec2 size = lamp.lightMap->size();
        const glm::dvec2 from = lamp.lightMapUv(origin + part.first * direction) * size - 0.5;
        const glm::dvec2 to = lamp.lightMapUv(origin + part.last * direction) * size - 0.5;
        for (int axis = 0; axis < 2; ++axis) {
            const double low = std::max(std::ceil(std::min(from[axis], to[axis])), 0.0);
            const double high =
                std::min(std::floor(std::max(from[axis], to[axis])), size[axis] - 1.0);
            for (double texel = low; texel <= high && from[axis] != to[axis]; texel += 1.0) {
                places.push_back(
                    glm::clamp((texel - from[axis]) / (to[axis] - from[axis]), 0.0, 1.0));
            }
        }
    }
    std::sort(places.begin(), places.end());
    return places;
}

/// Where to ask for visibility, ascending from 0 to 1.
std::vector<double> BeamIntegrator::Segment::probes(int count) const {
    std::vector<double> places;
    const int half = std::max(count / 2, 2);
    for (int i = 0; i < half; ++i) {
        const double fraction = double(i) / (half - 1);
        places.push_back(fraction);
        places.push_back(placeOf(part.first + fraction * part.length()));
    }
    std::sort(places.begin(), places.end());
    return places;
}

Integral BeamIntegrator::State::alongLamp(const Lamp& lamp, const BeamRay& ray) const {
    const glm::dvec3 origin = lamp.toBeam(ray.origin - lamp.light.frame.position);
    const glm::dvec3 direction = lamp.toBeam(ray.direction);
    const std::optional<Interval> part =
        lamp.clip(origin, direction, {ray.first, std::min(ray.last, kEndlessMetres)});
    if (!part) {
        return {};
    }
    const Segment segment(lamp, origin, direction, *part);
    std::vector<Interval> lit = {{0.0, 1.0}};
    if (isVisible) {
        lit = litStretches(
            [&](double x) {
                return isVisible(lamp.light, ray.origin + segment.distanceAt(x) * ray.direction);
            },
            segment.probes(accuracy.visibilityProbes));
    }
    return integrateAdaptively([&](double x) { return segment.integrand(x, haze); },
                               cutAt(lit, segment.kinks()), accuracy.integral);
}

BeamIntegrator::BeamIntegrator(std::span<const SpotLight> lamps, std::span<const Image> images,
                               const Haze& haze, LampVisibility isVisible,
                               const BeamAccuracy& accuracy)
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
