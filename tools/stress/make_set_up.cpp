// Every class starts from an ordinary set-up and moves it to its corner.
#include "make_set_up.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/angles.h"
#include "random.h"

namespace ribalta::stress {
namespace {

constexpr double kHundredKilometres = 1e5;

/// What the classes change, and the measures they need.
struct Draft {
    SetUp setUp;
    Random random;
    double reach = 5.0;     ///< metres from the lamp to where the camera looks
    double distance = 5.0;  ///< metres from there to the camera

    SpotLight& lamp() { return setUp.lamps.front(); }
    glm::dvec3 target() { return lamp().frame.position + reach * lamp().frame.forward(); }
    double drawnAngle() { return std::clamp(lamp().outerConeAngle, kMinConeAngle, kMaxConeAngle); }
    /// A unit vector perpendicular to `axis`.
    glm::dvec3 across(const glm::dvec3& axis) {
        return glm::normalize(glm::cross(axis, random.direction()));
    }
    void stand(const glm::dvec3& position, const glm::dvec3& lookAtPoint) {
        setUp.camera.frame = lookAt(position, lookAtPoint, random.direction());
    }
    void lens(double verticalFov) {
        setUp.camera.lens = PerspectiveLens{std::clamp(verticalFov, 1e-4, 2.6), std::nullopt};
    }
};

SpotLight makeLamp(Random& random) {
    SpotLight lamp;
    lamp.frame = lookAt(random.between(0.0, 3.0) * random.direction(), 100.0 * random.direction(),
                        random.direction());
    lamp.intensityCandela = random.decades(1.0, 1e6);
    lamp.color = {float(random.between(0.2, 1.0)), float(random.unit()), float(random.unit())};
    lamp.outerConeAngle = random.decades(2.0, 60.0) * kDegree;
    // From soft all over to a hard edge.
    lamp.innerConeAngle = random.chance(0.3) ? lamp.outerConeAngle * random.between(0.9, 1.0)
                                             : lamp.outerConeAngle * random.unit();
    if (random.chance(0.25)) {
        lamp.beamShape = BeamShape::kPyramid;
    }
    return lamp;
}

PhaseFunction makePhase(Random& random, double largestG) {
    PhaseFunction phase;
    phase.kind = PhaseFunction::Kind(random.below(5));
    phase.g = random.between(-largestG, largestG);
    return phase;
}

Draft makeDraft(std::uint64_t seed, int number) {
    // Neighbouring numbers must not make neighbouring streams.
    Draft draft{{}, Random(Random(seed).next() ^ Random(~std::uint64_t(number)).next())};
    Random& random = draft.random;
    SetUp& setUp = draft.setUp;
    setUp.seed = seed;
    setUp.number = number;
    setUp.lamps = {makeLamp(random)};
    setUp.haze.scatteringPerMetre = random.decades(1e-4, 0.3);
    setUp.haze.absorptionPerMetre =
        random.chance(0.5) ? 0.0 : random.unit() * setUp.haze.scatteringPerMetre;
    setUp.haze.phase = makePhase(random, 0.8);
    setUp.width = 17 + random.below(40);
    setUp.height = 13 + random.below(30);
    setUp.sheets = int(random.decades(8.0, 200.0));
    setUp.camera.nearMetres = random.decades(0.01, 0.3);
    draft.reach = random.decades(0.5, 20.0);
    draft.distance = random.decades(0.5, 30.0);
    draft.stand(draft.target() + draft.distance * random.direction(), draft.target());
    draft.lens(random.between(0.2, 1.6));
    if (random.chance(0.15)) {
        setUp.camera.farMetres = setUp.camera.nearMetres + random.decades(0.1, 100.0);
    }
    return draft;
}

/// A rectangle across the beam at `share` of the way to the target, big enough or a part of it.
Rectangle acrossBeam(Draft& draft, double share, double size) {
    Random& random = draft.random;
    const SpotLight& lamp = draft.lamp();
    // Turned by up to 50 degrees: edge on to the lamp a shadow map says nothing.
    const glm::dvec3 normal = glm::normalize(
        -lamp.frame.forward() + random.between(0.0, 1.1) * draft.across(lamp.frame.forward()));
    Rectangle rectangle;
    const double depth = share * draft.reach;
    const double radius = depth * std::tan(std::min(draft.drawnAngle(), 1.0));
    rectangle.centre = lamp.frame.position + depth * lamp.frame.forward() +
                       0.5 * radius * draft.across(lamp.frame.forward());
    rectangle.halfU = size * radius * draft.across(normal);
    rectangle.halfV = random.between(0.3, 1.0) * glm::cross(normal, rectangle.halfU);
    return rectangle;
}

void plain(Draft& /*draft*/) {}

void narrow(Draft& draft) {
    SpotLight& lamp = draft.lamp();
    lamp.outerConeAngle = draft.random.decades(0.05, 2.5) * kDegree;
    lamp.innerConeAngle = lamp.outerConeAngle * draft.random.unit();
    draft.distance = draft.random.decades(1.0, 300.0);
    draft.stand(draft.target() + draft.distance * draft.random.direction(), draft.target());
    const double radius = draft.reach * std::tan(draft.drawnAngle());
    draft.lens(draft.random.between(3.0, 30.0) * radius / draft.distance);
}

void wide(Draft& draft) {
    SpotLight& lamp = draft.lamp();
    lamp.outerConeAngle = draft.random.between(50.0, 85.0) * kDegree;
    lamp.innerConeAngle = lamp.outerConeAngle * draft.random.unit();
}

void atApex(Draft& draft) {
    Random& random = draft.random;
    const glm::dvec3 apex = draft.lamp().frame.position;
    // From exactly there to a metre away.
    const double away = random.chance(0.4) ? 0.0 : random.decades(1e-3, 1.0);
    const glm::dvec3 place = apex + away * random.direction();
    const glm::dvec3 ahead = draft.lamp().frame.forward();
    draft.setUp.camera.nearMetres = random.decades(1e-4, 0.1);
    draft.stand(place, place + (random.chance(0.5) ? ahead : random.direction()));
}

void onAxis(Draft& draft) {
    Random& random = draft.random;
    const Frame& lamp = draft.lamp().frame;
    const double along = random.decades(0.06, 30.0) * (random.chance(0.3) ? -1.0 : 1.0);
    const glm::dvec3 place = lamp.position + along * lamp.forward();
    const double side = random.chance(0.5) ? 1.0 : -1.0;
    draft.stand(place, place + side * lamp.forward());
    // The middle pixel's ray is the axis.
    draft.setUp.width |= 1;
    draft.setUp.height |= 1;
}

void alongEdge(Draft& draft) {
    Random& random = draft.random;
    const Frame& lamp = draft.lamp().frame;
    const bool square = draft.lamp().beamShape == BeamShape::kPyramid;
    const glm::dvec3 outwards = square ? lamp.right() : draft.across(lamp.forward());
    const glm::dvec3 edge =
        std::cos(draft.drawnAngle()) * lamp.forward() + std::sin(draft.drawnAngle()) * outwards;
    const glm::dvec3 place =
        lamp.position + (random.chance(0.3) ? 0.0 : random.decades(0.05, 30.0)) * edge;
    draft.stand(place, place + (random.chance(0.5) ? 1.0 : -1.0) * edge);
    draft.setUp.width |= 1;
    draft.setUp.height |= 1;
}

void behindLamp(Draft& draft) {
    const Frame& lamp = draft.lamp().frame;
    const glm::dvec3 place = lamp.position - draft.random.decades(1e-3, 20.0) * lamp.forward() +
                             draft.random.decades(1e-3, 5.0) * draft.across(lamp.forward());
    draft.stand(place, draft.target());
}

void farAway(Draft& draft) {
    Random& random = draft.random;
    draft.distance = random.decades(300.0, 0.99 * kHundredKilometres);
    draft.reach = random.decades(1.0, 300.0);
    draft.stand(draft.target() + draft.distance * random.direction(), draft.target());
    const double radius = draft.reach * std::tan(draft.drawnAngle());
    draft.lens(random.between(1.0, 6.0) * std::max(radius, draft.reach) / draft.distance);
    draft.setUp.camera.farMetres = kInfinity;
    draft.setUp.camera.nearMetres = random.decades(0.1, 100.0);
    draft.setUp.haze.scatteringPerMetre = random.decades(1e-8, 3.0 / draft.distance);
    draft.setUp.haze.absorptionPerMetre = 0.0;
}

void close(Draft& draft) {
    Random& random = draft.random;
    const double away = random.decades(1e-3, 0.3);
    const glm::dvec3 apex = draft.lamp().frame.position;
    draft.setUp.camera.nearMetres = 0.1 * away;
    draft.stand(apex + away * random.direction(), apex + 0.05 * draft.lamp().frame.forward());
}

void alongPlanes(Draft& draft) {
    // The light runs across the view: within the thesis's planes.
    const glm::dvec3 side = draft.across(draft.lamp().frame.forward());
    draft.stand(draft.target() + draft.distance * side, draft.target());
}

void surfaces(Draft& draft) {
    Random& random = draft.random;
    // A wall across the view: from the near plane itself to far behind the beam.
    const Camera& camera = draft.setUp.camera;
    const double nearest = std::max(camera.nearMetres, 1e-3);
    const double depth = random.chance(0.3) ? nearest * (1.0 + random.decades(1e-7, 1e-2))
                                            : random.decades(nearest, 200.0);
    Rectangle wall;
    wall.centre = camera.frame.position + depth * camera.frame.forward();
    wall.halfU = 40.0 * depth * camera.frame.right();
    wall.halfV = 40.0 * depth * camera.frame.up();
    draft.setUp.rectangles = {wall};
}

void thickHaze(Draft& draft) {
    Random& random = draft.random;
    draft.setUp.haze.scatteringPerMetre = random.chance(0.1) ? 0.0 : random.decades(0.3, 1000.0);
    draft.setUp.haze.absorptionPerMetre = random.chance(0.7) ? 0.0 : random.decades(0.1, 1000.0);
}

void brightOrDark(Draft& draft) {
    Random& random = draft.random;
    const std::array<double, 4> special = {0.0, 1e9, 1e-6, 1e9};
    draft.lamp().intensityCandela =
        random.chance(0.5) ? special[std::size_t(random.below(4))] : random.decades(1e-6, 1e9);
}

void farFromOrigin(Draft& draft) {
    draft.setUp =
        moved(draft.setUp, glm::dmat3(1.0), kHundredKilometres * draft.random.direction());
}

void scaled(Draft& draft) {
    const double scale = draft.random.chance(0.5) ? 1e-3 : 1e3;
    SetUp& setUp = draft.setUp;
    setUp.camera.frame.position *= scale;
    setUp.camera.nearMetres *= scale;
    setUp.camera.farMetres *= scale;
    for (SpotLight& lamp : setUp.lamps) {
        lamp.frame.position *= scale;
        lamp.intensityCandela *= scale * scale;
    }
    setUp.haze.scatteringPerMetre /= scale;
    setUp.haze.absorptionPerMetre /= scale;
}

void manyLamps(Draft& draft) {
    const int count = 2 + draft.random.below(11);
    for (int i = 1; i < count; ++i) {
        SpotLight lamp = makeLamp(draft.random);
        lamp.frame =
            lookAt(lamp.frame.position,
                   draft.target() + draft.random.between(0.0, 2.0) * draft.random.direction(),
                   draft.random.direction());
        if (draft.random.chance(0.3)) {
            lamp.lightMap = LightMap{0, draft.random.between(0.0, 6.3)};
        }
        draft.setUp.lamps.push_back(lamp);
    }
}

void finiteRange(Draft& draft) {
    draft.lamp().rangeMetres = draft.random.chance(0.15)
                                   ? draft.random.decades(1e-3, 0.06)
                                   : draft.reach * draft.random.decades(0.1, 4.0);
}

void projectsPicture(Draft& draft) {
    draft.lamp().lightMap =
        LightMap{draft.random.below(int(lightMaps().size())), draft.random.between(-3.2, 3.2)};
    draft.setUp.sheets = int(draft.random.decades(16.0, 1024.0));
}

void casters(Draft& draft) {
    Random& random = draft.random;
    const int count = 1 + random.below(3);
    for (int i = 0; i < count; ++i) {
        draft.setUp.rectangles.push_back(
            acrossBeam(draft, random.between(0.2, 0.9), random.between(0.1, 0.7)));
    }
    if (random.chance(0.5)) {
        draft.setUp.rectangles.push_back(acrossBeam(draft, random.between(1.0, 2.0), 3.0));
    }
}

void sharpPhase(Draft& draft) {
    Random& random = draft.random;
    PhaseFunction& phase = draft.setUp.haze.phase;
    phase.kind = random.chance(0.7) ? PhaseFunction::Kind::kHenyeyGreenstein
                                    : PhaseFunction::Kind::kCornetteShanks;
    const std::array<double, 6> special = {0.95, -0.95, 0.99, -0.99, 0.9, -0.9};
    phase.g = special[std::size_t(random.below(6))];
    if (random.chance(0.5)) {
        onAxis(draft);
    }
}

void sampleCounts(Draft& draft) {
    const std::array<int, 4> special = {1, 2, 3, 8192};
    draft.setUp.sheets = draft.random.chance(0.3) ? special[std::size_t(draft.random.below(4))]
                                                  : int(draft.random.decades(1.0, 8192.0));
}

void orthographic(Draft& draft) {
    Random& random = draft.random;
    const double half = random.decades(0.05, 20.0);
    draft.setUp.camera.lens = OrthographicLens{half, half * random.between(0.5, 1.0)};
    draft.setUp.camera.nearMetres = random.chance(0.3) ? 0.0 : random.decades(0.01, 1.0);
    draft.setUp.camera.farMetres =
        draft.setUp.camera.nearMetres + draft.distance * random.decades(0.5, 1000.0);
}

void anything(Draft& draft);

struct Kind {
    const char* name;
    void (*change)(Draft&);
};

constexpr std::array kKinds = {Kind{"plain", plain},
                               Kind{"narrow cone", narrow},
                               Kind{"wide cone", wide},
                               Kind{"camera at the apex", atApex},
                               Kind{"camera on the axis", onAxis},
                               Kind{"camera along the cone", alongEdge},
                               Kind{"camera behind the lamp", behindLamp},
                               Kind{"up to 100 km away", farAway},
                               Kind{"from 1 mm away", close},
                               Kind{"light along the planes", alongPlanes},
                               Kind{"a surface from the near plane on", surfaces},
                               Kind{"haze up to 1000 per metre", thickHaze},
                               Kind{"0 to 1e9 cd", brightOrDark},
                               Kind{"100 km from the origin", farFromOrigin},
                               Kind{"scaled by 1e-3 or 1e3", scaled},
                               Kind{"many lamps", manyLamps},
                               Kind{"finite range", finiteRange},
                               Kind{"light maps", projectsPicture},
                               Kind{"casters", casters},
                               Kind{"sharp phase functions", sharpPhase},
                               Kind{"1 to 8192 samples", sampleCounts},
                               Kind{"orthographic", orthographic},
                               Kind{"anything", anything}};

/// Two or three of the others, one after another.
void anything(Draft& draft) {
    const int count = 2 + draft.random.below(2);
    for (int i = 0; i < count; ++i) {
        kKinds[std::size_t(draft.random.below(int(kKinds.size()) - 1))].change(draft);
    }
}

constexpr auto kNames = [] {
    std::array<const char*, kKinds.size()> names{};
    for (std::size_t i = 0; i < names.size(); ++i) {
        names[i] = kKinds[i].name;
    }
    return names;
}();

}  // namespace

std::span<const char* const> kindNames() {
    return kNames;
}

SetUp makeSetUp(std::uint64_t seed, int number) {
    Draft draft = makeDraft(seed, number);
    draft.setUp.kind = number % int(kKinds.size());
    kKinds[std::size_t(draft.setUp.kind)].change(draft);
    return draft.setUp;
}

}  // namespace ribalta::stress
