#include "sky_set_up.h"

#include <cmath>
#include <cstdio>
#include <numbers>

#include "base/angles.h"
#include "random.h"

namespace ribalta::stress {
namespace {

enum Kind {
    kOnTheGround,
    kAtTheTop,
    kInSpace,
    kInTheAir,
    kSunAtTheHorizon,
    kThickHaze,
    kTinyPlanet,
    kScaleHeights,
    kFourOrders,
    kAnything,
    kKinds
};
constexpr const char* kNames[] = {
    "on the ground",      "at the air's top", "in space",         "in the air",
    "sun at the horizon", "Mie times 50",     "planet of 400 km", "scale heights of 0.1 to 50 km",
    "four orders",        "anything"};
static_assert(std::size(kNames) == kKinds);

double nearGround(Random& random) {
    const double heights[] = {0.0, 0.0, 1e-3, 2.0};
    return heights[random.below(4)];
}

double nearTop(Random& random, double top) {
    const double off[] = {0.0, 0.0, -1e-3, 1e-3, -1.0, 1.0};
    return top + off[random.below(6)];
}

double anyHeight(Random& random, double top) {
    switch (random.below(4)) {
        case 0:
            return nearGround(random);
        case 1:
            return nearTop(random, top);
        case 2:
            return random.decades(1.0, top);
        default:
            return top * random.decades(1.001, 600.0);
    }
}

/// Angle from the mathematical horizon down to the ground's.
double dip(const SkySetUp& setUp) {
    const double radius = setUp.air.groundRadiusMetres;
    const double height = setUp.heightMetres;
    return std::atan2(std::sqrt(height * (2.0 * radius + height)), radius);
}

void changeAir(Random& random, Kind kind, Atmosphere& air) {
    if (kind == kThickHaze) {
        air.mieScatteringPerMetre *= 50.0;
        air.mieExtinctionPerMetre *= 50.0;
    } else if (kind == kTinyPlanet) {
        air.groundRadiusMetres = 400e3;
    } else if (kind == kScaleHeights) {
        air.rayleighScaleHeightMetres = random.decades(100.0, 50e3);
        air.mieScaleHeightMetres = random.decades(100.0, 50e3);
    }
}

}  // namespace

std::span<const char* const> skyKindNames() {
    return kNames;
}

SkySetUp makeSkySetUp(std::uint64_t seed, int number) {
    Random random(seed * 1000003 + std::uint64_t(number));
    random.next();
    SkySetUp setUp;
    setUp.seed = seed;
    setUp.number = number;
    setUp.kind = number % kKinds;
    const Kind kind = Kind(setUp.kind);
    changeAir(random, kind, setUp.air);
    if (kind == kAnything) {
        for (const Kind change : {kThickHaze, kTinyPlanet, kScaleHeights}) {
            if (random.chance(0.5)) {
                changeAir(random, change, setUp.air);
            }
        }
        setUp.air.mieG = random.between(-0.9, 0.95);
        setUp.air.groundAlbedo = glm::dvec3(random.unit());
    }
    const double top = setUp.air.topMetres;
    switch (kind) {
        case kOnTheGround:
            setUp.heightMetres = nearGround(random);
            break;
        case kAtTheTop:
            setUp.heightMetres = nearTop(random, top);
            break;
        case kInSpace:
            setUp.heightMetres = top * random.decades(1.001, 600.0);
            break;
        case kInTheAir:
            setUp.heightMetres = random.decades(1.0, top);
            break;
        default:
            setUp.heightMetres = anyHeight(random, top);
    }
    setUp.sunElevation = random.between(-90.0, 90.0) * kDegree;
    if (kind == kSunAtTheHorizon || random.chance(0.4)) {
        setUp.sunElevation = -dip(setUp) + random.between(-1.0, 1.0) * kDegree;
    }
    setUp.around = random.chance(0.3) ? 0.0 : random.between(0.0, std::numbers::pi);
    setUp.fourOrders = kind == kFourOrders;
    return setUp;
}

std::string describe(const SkySetUp& setUp) {
    const Atmosphere& air = setUp.air;
    char text[512];
    std::snprintf(
        text, sizeof text,
        "case %d of seed %llu, %s: viewer at %.17g m, sun at %.17g degrees, %.17g degrees "
        "beside it\n  ground %.17g m, top %.17g m, scale heights %.17g and %.17g m, Mie "
        "%.6g per m, g %.17g, albedo %.6g\n",
        setUp.number, static_cast<unsigned long long>(setUp.seed), kNames[std::size_t(setUp.kind)],
        setUp.heightMetres, setUp.sunElevation / kDegree, setUp.around / kDegree,
        air.groundRadiusMetres, air.topMetres, air.rayleighScaleHeightMetres,
        air.mieScaleHeightMetres, air.mieScatteringPerMetre.x, air.mieG, air.groundAlbedo.x);
    return text;
}

}  // namespace ribalta::stress
