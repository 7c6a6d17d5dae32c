// Single scattering along a ray, straight from the definitions (README.md of this folder).
#include "exact_beams.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtx/component_wise.hpp>

#include "base/angles.h"
#include "integrate.h"
#include "light_map_value.h"

namespace ribalta::stress {
namespace {

// The rules of the program: a beam begins at the plane of its lens; the falloff's cosines lie at
// least so far apart; nothing nearer to a lamp casts a shadow.
constexpr double kLens = 0.05;
constexpr double kLeastRamp = 0.001;
constexpr double kShadowNear = 0.05;
/// Shadow maps are this many texels wider than the beam.
constexpr double kShadowRim = 4.0;

/// Of light that is turned by the angle whose cosine is `mu`, per steradian.
double phaseOf(const PhaseFunction& phase, double mu) {
    const double g = phase.g;
    const double spread = 1.0 + g * g - 2.0 * g * mu;
    switch (phase.kind) {
        case PhaseFunction::Kind::kGibbons:
            return phase.k * (1.0 + 9.0 * std::pow(0.5 * (1.0 + mu), 8.0));
        case PhaseFunction::Kind::kHenyeyGreenstein:
            return (1.0 - g * g) / (4.0 * kPi * std::pow(spread, 1.5));
        case PhaseFunction::Kind::kCornetteShanks:
            return 3.0 / (8.0 * kPi) * (1.0 - g * g) * (1.0 + mu * mu) /
                   ((2.0 + g * g) * std::pow(spread, 1.5));
        case PhaseFunction::Kind::kRayleigh:
            return 3.0 / (16.0 * kPi) * (1.0 + mu * mu);
        case PhaseFunction::Kind::kIsotropic:
            break;
    }
    return 1.0 / (4.0 * kPi);
}

/// Where offset + slope t >= 0 holds of an interval; empty (first > last) where nowhere.
Interval keepWhere(double offset, double slope, const Interval& interval) {
    if (slope == 0.0) {
        return offset >= 0.0 ? interval : Interval{1.0, 0.0};
    }
    const double zero = -offset / slope;
    return slope > 0.0 ? Interval{std::max(interval.first, zero), interval.last}
                       : Interval{interval.first, std::min(interval.last, zero)};
}

/// Texture units place a lookup between texels in eight bits.
constexpr double kFilterStep = 1.0 / 256.0;

/// A rectangle as a lamp sees it: corners in lamp space, z the depth.
using Corners = std::array<glm::dvec3, 4>;

}  // namespace

struct ExactBeams::Lamp {
    glm::dvec3 position{0.0};
    glm::dmat3 lampFromWorld{1.0};  // x right, y up, z the way it shines
    glm::dvec3 candela{0.0};
    double angle = 0.0;
    double tangent = 0.0;
    double dropOuter = 0.0;  // 1 - cosine of the cone's half angle, with all its digits
    double dropInner = 0.0;
    double cosRotation = 1.0;
    double sinRotation = 0.0;
    double range = kInfinity;
    bool pyramid = false;
    std::optional<LightMap> lightMap;
    double shadowTexel = 0.0;  // slope
    std::vector<Corners> casters;

    /// Whether a point of the lamp's space lies in the beam, whose half angle has the tangent
    /// `wide`.
    bool holds(const glm::dvec3& p, double wide, bool planeRange) const {
        if (p.z < kLens || (planeRange ? p.z : glm::length(p)) > range) {
            return false;
        }
        // By the angle's tangent: its cosine loses half the digits of a narrow cone.
        return (pyramid ? std::max(std::abs(p.x), std::abs(p.y))
                        : std::sqrt(p.x * p.x + p.y * p.y)) <= p.z * wide;
    }

    glm::dvec2 lightMapUv(const glm::dvec3& p) const {
        const double scale = 0.5 / (tangent * p.z);
        return {0.5 + scale * (cosRotation * p.x + sinRotation * p.y),
                0.5 - scale * (cosRotation * p.y - sinRotation * p.x)};
    }

    /// Candela towards a point, without and with the light map.
    glm::dvec3 plainIntensity(const glm::dvec3& p, double r, double cosShift) const {
        glm::dvec3 value = candela;
        if (range < kInfinity) {
            const double square = (r / range) * (r / range);
            value *= std::max(0.0, 1.0 - square * square);
        }
        if (!pyramid) {
            // Differences of cosines by what they lack of 1, so that they keep their digits.
            const double width = std::max(dropOuter - dropInner, kLeastRamp);
            const double drop = (p.x * p.x + p.y * p.y) / (r * (r + p.z));
            const double falloff = std::clamp((dropOuter - drop + cosShift) / width, 0.0, 1.0);
            value *= falloff * falloff;
        }
        return value;
    }
    glm::dvec3 intensity(const glm::dvec3& p, double r, double cosShift) const {
        glm::dvec3 value = plainIntensity(p, r, cosShift);
        return lightMap ? value * lightMapValue(lightMap->image, lightMapUv(p)) : value;
    }

    Interval inside(const glm::dvec3& origin, const glm::dvec3& direction, const Interval& interval,
                    double wide, bool planeRange) const;
    Interval shadow(const Corners& corners, const glm::dvec3& origin, const glm::dvec3& direction,
                    double texels, const Interval& interval) const;
};

/// Where the ray is inside the beam: an interval, the beam being convex. By all places where it may
/// cross the beam's surface, in extended precision, and a look at the middle between neighbours.
Interval ExactBeams::Lamp::inside(const glm::dvec3& origin, const glm::dvec3& direction,
                                  const Interval& interval, double wide, bool planeRange) const {
    using Real = long double;
    const double nearest = -glm::dot(origin, direction);
    const glm::dvec3 p = origin + nearest * direction;
    std::vector<double> places = {interval.first, interval.last};
    const auto add = [&](Real s) {
        const auto t = double(s + Real(nearest));
        if (t > interval.first && t < interval.last) {
            places.push_back(t);
        }
    };
    const auto addRoots = [&](Real a, Real b, Real c) {  // a s^2 + 2 b s + c = 0
        const Real discriminant = b * b - a * c;
        if (discriminant >= 0.0L && a != 0.0L) {
            add((-b - std::sqrt(discriminant)) / a);
            add((-b + std::sqrt(discriminant)) / a);
        }
        if (b != 0.0L) {
            add(-0.5L * c / b);  // where a is nothing but rounding
        }
    };
    if (direction.z != 0.0) {
        add((Real(kLens) - p.z) / direction.z);
    }
    if (pyramid) {
        for (int axis = 0; axis < 2; ++axis) {
            for (const Real sign : {-1.0L, 1.0L}) {
                const Real slope = Real(wide) * direction.z - sign * direction[axis];
                if (slope != 0.0L) {
                    add(-(Real(wide) * p.z - sign * p[axis]) / slope);
                }
            }
        }
    } else {
        const Real k = Real(wide) * wide;
        const auto form = [&](const glm::dvec3& u, const glm::dvec3& v) {
            return k * u.z * v.z - Real(u.x) * v.x - Real(u.y) * v.y;
        };
        addRoots(form(direction, direction), form(direction, p), form(p, p));
    }
    if (range < kInfinity && planeRange) {
        if (direction.z != 0.0) {
            add((Real(range) - p.z) / direction.z);
        }
    } else if (range < kInfinity) {
        const Real square = Real(range) * range - Real(glm::dot(p, p));
        if (square > 0.0L) {
            add(-std::sqrt(square));
            add(std::sqrt(square));
        }
    }
    std::sort(places.begin(), places.end());
    Interval result{kInfinity, -kInfinity};
    for (std::size_t i = 1; i < places.size(); ++i) {
        const double middle = 0.5 * (places[i - 1] + places[i]);
        if (places[i - 1] < places[i] &&
            holds(p + (middle - nearest) * direction, wide, planeRange)) {
            result.first = std::min(result.first, places[i - 1]);
            result.last = std::max(result.last, places[i]);
        }
    }
    return result;
}

/// Where the ray runs in the shadow of a rectangle that is `texels` of the shadow map larger on
/// every side and, by what it leans over so many texels, nearer to the lamp. Not longer than the
/// truth where texels is negative, not shorter where it is positive.
Interval ExactBeams::Lamp::shadow(const Corners& corners, const glm::dvec3& origin,
                                  const glm::dvec3& direction, double texels,
                                  const Interval& interval) const {
    const double grow = texels * shadowTexel;
    const glm::dvec3 normal =
        glm::normalize(glm::cross(corners[1] - corners[0], corners[3] - corners[0]));
    const double height = glm::dot(normal, corners[0]);
    const double size = glm::length(corners[2] - corners[0]);
    if (std::abs(height) < 1e-9 * size) {  // edge on: anything between no and much shadow
        return texels > 0.0 ? interval : Interval{1.0, 0.0};
    }
    Interval part = interval;
    const auto keep = [&](const glm::dvec3& weights, double constant) {
        if (part.first <= part.last) {
            part =
                keepWhere(glm::dot(weights, origin) + constant, glm::dot(weights, direction), part);
        }
    };
    // Behind the plane: normal . p / height >= 1, the inverse depth off by what it leans.
    const glm::dvec3 plane = normal / height;
    const double lean = (std::abs(plane.x) + std::abs(plane.y)) * grow;
    const double rounding = texels == 0.0 ? 0.0 : std::copysign(2e-6, texels);
    keep(plane + glm::dvec3(0.0, 0.0, lean), -1.0 + rounding);
    // The shadow map begins at its near plane: what casts must lie behind it.
    keep(glm::dvec3(0.0, 0.0, 1.0 / kShadowNear * (1.0 + rounding)) - plane, 0.0);
    const glm::dvec3 middle = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        glm::dvec3 edge = glm::cross(corners[i], corners[(i + 1) % corners.size()]);
        edge *= glm::dot(edge, middle) < 0.0 ? -1.0 : 1.0;
        keep(edge + glm::dvec3(0.0, 0.0, grow * std::hypot(edge.x, edge.y)), 0.0);
    }
    return part;
}

/// The part of a ray in one lamp's beam, in the lamp's space. x of 0..1 runs over it evenly in the
/// lamp's projection (1 / z even), which takes 1 / r^2 out of the integrand.
struct ExactBeams::Stretch {
    const Lamp& lamp;
    const Haze& haze;
    glm::dvec3 origin;
    glm::dvec3 direction;
    Interval part;
    double cosShift;
    double z0 = origin.z + part.first * direction.z;
    double z1 = origin.z + part.last * direction.z;

    double metresAt(double x) const {
        return part.first + part.length() * x * z0 / (z1 * (1.0 - x) + x * z0);
    }
    double placeOf(double metres) const {
        const double f = std::clamp((metres - part.first) / part.length(), 0.0, 1.0);
        return f * z1 / (z0 * (1.0 - f) + f * z1);
    }
    /// cd/m2 per metre of the ray.
    glm::dvec3 perMetre(double t, bool withMap) const {
        const glm::dvec3 p = origin + t * direction;
        const double r = glm::length(p);
        const double mu = std::clamp(-glm::dot(p, direction) / r, -1.0, 1.0);
        const double share = phaseOf(haze.phase, mu) * haze.scatteringPerMetre *
                             std::exp(-haze.extinctionPerMetre() * (r + t)) / (r * r);
        return share *
               (withMap ? lamp.intensity(p, r, cosShift) : lamp.plainIntensity(p, r, cosShift));
    }
    glm::dvec3 perPlace(double x, bool withMap = true) const {
        const double w = z1 * (1.0 - x) + x * z0;
        return perMetre(metresAt(x), withMap) * (part.length() * (z0 / w) * (z1 / w));
    }

    /// Where the cone's falloff reaches 1, and where a light map's filter goes over to the next
    /// texels.
    void addKinks(std::vector<double>& places) const {
        const double drop = lamp.dropOuter - std::max(lamp.dropOuter - lamp.dropInner, kLeastRamp);
        if (!lamp.pyramid && drop + cosShift > 0.0) {
            const double wide = std::tan(2.0 * std::asin(std::sqrt(0.5 * (drop + cosShift))));
            const Interval full = lamp.inside(origin, direction, part, wide, true);
            if (full.first < full.last) {
                places.push_back(placeOf(full.first));
                places.push_back(placeOf(full.last));
            }
        }
        if (!lamp.lightMap) {
            return;
        }
        const glm::dvec2 from = lamp.lightMapUv(origin + part.first * direction);
        const glm::dvec2 to = lamp.lightMapUv(origin + part.last * direction);
        for (int axis = 0; axis < 2; ++axis) {
            for (int texel = 0; from[axis] != to[axis] && texel < lightMapSide(); ++texel) {
                const double centre = (texel + 0.5) / lightMapSide();
                places.push_back((centre - from[axis]) / (to[axis] - from[axis]));
            }
        }
    }

    /// Cuts so that not even a layer of a millimetre in a kilometre hides between two nodes.
    std::vector<double> cuts() const {
        std::vector<double> places;
        for (int k = 1; k <= 40; k += k < 4 ? 1 : 6) {
            places.push_back(std::ldexp(1.0, -k));
            places.push_back(1.0 - std::ldexp(1.0, -k));
        }
        for (const double depths : {0.1, 0.5, 2.0, 6.0, 20.0}) {
            places.push_back(
                placeOf(part.first + depths / std::max(haze.extinctionPerMetre(), 1e-30)));
        }
        addKinks(places);
        std::sort(places.begin(), places.end());
        return places;
    }

    /// Places close enough together to see everything the integrand does: even, ever closer to the
    /// ends, even in metres, and where the haze takes a given share.
    std::vector<double> grid(int even) const {
        std::vector<double> places = {0.0, 1.0};
        for (int i = 1; i < even; ++i) {
            places.push_back(double(i) / even);
            places.push_back(placeOf(part.first + part.length() * i / even));
        }
        for (int k = 1; k <= 40; ++k) {
            places.push_back(std::ldexp(1.0, -k));
            places.push_back(1.0 - std::ldexp(1.0, -k));
        }
        for (int k = 1; k <= 64; ++k) {
            places.push_back(
                placeOf(part.first + 0.25 * k / std::max(haze.extinctionPerMetre(), 1e-30)));
        }
        addKinks(places);
        for (double& place : places) {
            place = std::clamp(place, 0.0, 1.0);
        }
        std::sort(places.begin(), places.end());
        places.erase(std::unique(places.begin(), places.end()), places.end());
        return places;
    }
};

ExactBeams::~ExactBeams() = default;

ExactBeams::ExactBeams(const SetUp& setUp, int shadowSide) : haze_(setUp.haze) {
    for (const SpotLight& light : setUp.lamps) {
        Lamp lamp;
        lamp.position = light.frame.position;
        lamp.lampFromWorld = glm::transpose(
            glm::dmat3(light.frame.right(), light.frame.up(), light.frame.forward()));
        lamp.candela = glm::dvec3(light.color) * light.intensityCandela;
        lamp.angle = std::clamp(light.outerConeAngle, kMinConeAngle, kMaxConeAngle);
        lamp.tangent = std::tan(lamp.angle);
        const double inner = std::clamp(light.innerConeAngle, 0.0, lamp.angle);
        lamp.dropOuter = 2.0 * std::sin(0.5 * lamp.angle) * std::sin(0.5 * lamp.angle);
        lamp.dropInner = 2.0 * std::sin(0.5 * inner) * std::sin(0.5 * inner);
        lamp.range = light.rangeMetres;
        lamp.pyramid = light.beamShape == BeamShape::kPyramid;
        lamp.lightMap = light.lightMap;
        if (lamp.lightMap) {
            lamp.cosRotation = std::cos(lamp.lightMap->rotationRadians);
            lamp.sinRotation = std::sin(lamp.lightMap->rotationRadians);
        }
        if (shadowSide > 0) {
            lamp.shadowTexel = 2.0 * lamp.tangent / ((1.0 - kShadowRim / shadowSide) * shadowSide);
        }
        for (const Rectangle& rectangle : setUp.rectangles) {
            Corners corners;
            for (std::size_t i = 0; i < corners.size(); ++i) {
                const double u = i == 0 || i == 3 ? -1.0 : 1.0;
                const double v = i < 2 ? -1.0 : 1.0;
                corners[i] = lamp.lampFromWorld * (rectangle.centre + u * rectangle.halfU +
                                                   v * rectangle.halfV - lamp.position);
            }
            lamp.casters.push_back(corners);
        }
        lamps_.push_back(std::move(lamp));
    }
}

std::optional<ExactBeams::Stretch> ExactBeams::enter(const Lamp& lamp, const Ray& ray,
                                                     const Change& change) const {
    const glm::dvec3 origin = lamp.lampFromWorld * (ray.origin - lamp.position);
    const glm::dvec3 direction = lamp.lampFromWorld * ray.direction;
    // What a cosine is off changes the beam's edge too.
    const double wide = std::tan(lamp.angle + change.cosOuter / std::sin(lamp.angle));
    const Interval part =
        lamp.inside(origin, direction, {ray.first, ray.last}, wide, change.rangeByDepth);
    if (!(part.first < part.last)) {
        return std::nullopt;
    }
    return Stretch{lamp, haze_, origin, direction, part, change.cosOuter};
}

/// The lit stretches of 0..1, ascending.
std::vector<Interval> ExactBeams::lit(const Stretch& stretch, double shadowTexels) const {
    std::vector<Interval> result = {{0.0, 1.0}};
    for (const Corners& corners : stretch.lamp.casters) {
        const Interval dark = stretch.lamp.shadow(corners, stretch.origin, stretch.direction,
                                                  shadowTexels, stretch.part);
        if (!(dark.first < dark.last)) {
            continue;
        }
        const Interval gap{stretch.placeOf(dark.first), stretch.placeOf(dark.last)};
        std::vector<Interval> rest;
        for (const Interval& piece : result) {
            if (piece.first < gap.first) {
                rest.push_back({piece.first, std::min(piece.last, gap.first)});
            }
            if (piece.last > gap.last) {
                rest.push_back({std::max(piece.first, gap.last), piece.last});
            }
        }
        result = rest;
    }
    return result;
}

glm::dvec3 ExactBeams::along(const Ray& ray, const Change& change) const {
    glm::dvec3 sum(0.0);
    for (const Lamp& lamp : lamps_) {
        const std::optional<Stretch> stretch = enter(lamp, ray, change);
        if (!stretch) {
            continue;
        }
        const std::vector<double> cuts = stretch->cuts();
        std::vector<Interval> pieces;
        for (const Interval& piece : lit(*stretch, change.shadowTexels)) {
            double from = piece.first;
            for (const double cut : cuts) {
                if (cut > from && cut < piece.last) {
                    pieces.push_back({from, cut});
                    from = cut;
                }
            }
            pieces.push_back({from, piece.last});
        }
        sum += integrate([&](double x) { return stretch->perPlace(x); }, pieces, 1e-6);
    }
    return sum;
}

Roughness ExactBeams::inBeams(const Ray& ray, int samples, bool evenMetres, double pixelSlope,
                              bool parallel) const {
    Roughness result;
    for (const Lamp& lamp : lamps_) {
        const std::optional<Stretch> stretch = enter(lamp, ray, {0.0, 0.0, true});
        if (!stretch) {
            continue;
        }
        // The integrand over a variable of 0..1 in which the samples are even.
        const double length = stretch->part.length();
        const auto valueAt = [&](double x) {
            return evenMetres ? length * stretch->perMetre(stretch->metresAt(x), true)
                              : stretch->perPlace(x);
        };
        std::vector<double> places = stretch->grid(256);
        std::vector<glm::dvec3> values;
        double mean = 0.0;
        for (std::size_t i = 0; i < places.size(); ++i) {
            values.push_back(valueAt(places[i]));
            if (lamp.lightMap && i > 0) {
                mean +=
                    glm::compMax(stretch->perPlace(places[i], false)) * (places[i] - places[i - 1]);
            }
        }
        if (evenMetres) {
            for (double& place : places) {
                place = (stretch->metresAt(place) - stretch->part.first) / length;
            }
        }
        glm::dvec3 variation(0.0);
        glm::dvec3 slopeVariation(0.0);
        glm::dvec3 lastSlope(0.0);
        for (std::size_t i = 1; i < places.size(); ++i) {
            const glm::dvec3 step = values[i] - values[i - 1];
            // Two places may fall together where metres are even.
            const double width = places[i] - places[i - 1];
            const glm::dvec3 slope = width > 0.0 ? step / width : lastSlope;
            variation += glm::abs(step);
            if (i > 1) {
                slopeVariation += glm::abs(slope - lastSlope);
            }
            lastSlope = slope;
        }
        // Shadows' edges are jumps of what is there.
        for (const Interval& piece : lit(*stretch, 0.0)) {
            for (const double edge : {piece.first, piece.last}) {
                if (edge > 0.0 && edge < 1.0) {
                    variation += valueAt(edge);
                    slopeVariation = glm::dvec3(kInfinity);
                }
            }
        }
        if (!lamp.casters.empty()) {
            slopeVariation = glm::dvec3(kInfinity);
        }
        result.variation += glm::compMax(variation);
        result.slopeVariation += glm::compMax(slopeVariation);
        if (lamp.lightMap) {
            const glm::dvec2 path =
                lamp.lightMapUv(stretch->origin + stretch->part.last * stretch->direction) -
                lamp.lightMapUv(stretch->origin + stretch->part.first * stretch->direction);
            const double nearest = parallel ? 1.0 : stretch->part.last;
            const double pixel =
                pixelSlope * nearest / (2.0 * lamp.tangent * std::min(stretch->z0, stretch->z1));
            const double texels =
                lightMapSide() * std::max(0.5 * glm::length(path) / samples, pixel);
            // Below a texel no smaller picture is read.
            result.lightMapChange +=
                mean * (texels < 0.7
                            ? kFilterStep
                            : kFilterStep + lightMapChange(lamp.lightMap->image, 4.0 * texels));
        }
    }
    return result;
}

Roughness ExactBeams::alongRay(const Ray& ray) const {
    Roughness result;
    result.slopeVariation = kInfinity;
    for (const Lamp& lamp : lamps_) {
        const std::optional<Stretch> stretch = enter(lamp, ray, {});
        if (!stretch) {
            continue;
        }
        glm::dvec3 variation(0.0);
        glm::dvec3 before(0.0);  // dark outside the beam
        double last = 0.0;
        for (const double place : stretch->grid(256)) {
            const double metres = stretch->metresAt(place);
            const glm::dvec3 value = stretch->perMetre(metres, true);
            variation += glm::abs(value - before);
            before = value;
            if (lamp.lightMap) {
                result.lightMapChange +=
                    kFilterStep * glm::compMax(stretch->perPlace(place, false)) * (place - last);
                last = place;
            }
        }
        variation += before;
        for (const Interval& piece : lit(*stretch, 0.0)) {
            for (const double edge : {piece.first, piece.last}) {
                if (edge > 0.0 && edge < 1.0) {
                    variation += stretch->perMetre(stretch->metresAt(edge), true);
                }
            }
        }
        result.variation += glm::compMax(variation) * (ray.last - ray.first);
    }
    return result;
}

}  // namespace ribalta::stress
