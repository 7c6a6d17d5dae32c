#include "render/plan_sun_shadow.h"

#include <algorithm>
#include <cmath>

namespace ribalta {
namespace {

constexpr int kSmallestSide = 512;
constexpr int kLargestSide = 2048;
// A cascade's far end is at most so many times as far as its near one, where there are enough of
// them: its texels are then about three pixels wide near the eye and less than one far away.
constexpr double kDepthRatio = 4.0;
// Radii come in steps, so that texels keep their size while the camera moves.
constexpr double kStepsPerOctave = 4.0;

// Finer texels show nothing: a caster half a metre away already has a half-shadow as wide. And the
// filter, so many texels wide at most, would make shadows of high casters too sharp.
constexpr double kFinestTexel = 5e-3;  // metres

struct Sphere {
    glm::dvec3 centre{0.0};
    double radius = 0.0;
};

/// Metres along the view axis.
struct Depths {
    double nearest = 0.0;
    double farthest = 0.0;
};

glm::dmat3 turnTowards(const glm::dvec3& sun) {
    const glm::dvec3 aside = std::abs(sun.y) < 0.99 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    const glm::dvec3 right = glm::normalize(glm::cross(aside, sun));
    return glm::transpose(glm::dmat3(right, glm::cross(sun, right), sun));
}

Bounds inSunFrame(const glm::dmat3& sunFromWorld, const Bounds& bounds) {
    return transformed(glm::dmat4(sunFromWorld), bounds);
}

Depths depthsOf(const Camera& camera, const Bounds& bounds) {
    Depths depths{camera.farMetres, camera.nearMetres};
    for (int i = 0; i < 8; ++i) {
        const double depth =
            glm::dot(camera.frame.forward(), bounds.corner(i) - camera.frame.position);
        depths.nearest = std::min(depths.nearest, depth);
        depths.farthest = std::max(depths.farthest, depth);
    }
    return {std::max(depths.nearest, camera.nearMetres),
            std::min(depths.farthest, camera.farMetres)};
}

/// Around the part of the view between two depths.
Sphere aroundSlice(const Camera& camera, const glm::dvec2& half, const Depths& slice) {
    const double square = glm::dot(half, half);
    double middle = 0.5 * (slice.nearest + slice.farthest);
    double farRadius = std::sqrt(square);
    if (!camera.isOrthographic()) {
        // Where the corners at both ends are equally far, or at the far end.
        middle = std::min(middle * (1.0 + square), slice.farthest);
        farRadius *= slice.farthest;
    }
    return {camera.frame.position + middle * camera.frame.forward(),
            std::hypot(slice.farthest - middle, farRadius)};
}

/// The depths at which the cascades end, by equal ratios: as pixels grow with distance.
std::vector<double> splitDepths(const Camera& camera, const Depths& seen) {
    // All that is nearer is the first one's: there is little of it.
    const double start =
        std::max(seen.nearest, seen.farthest / std::pow(kDepthRatio, kMostSunCascades));
    const double ratio = seen.farthest / start;
    const int count = camera.isOrthographic()
                          ? 1  // whose pixels are equal everywhere
                          : std::clamp(int(std::ceil(std::log(ratio) / std::log(kDepthRatio))), 1,
                                       kMostSunCascades);
    std::vector<double> ends;
    for (int i = 1; i <= count; ++i) {
        ends.push_back(start * std::pow(ratio, double(i) / count));
    }
    return ends;
}

int sideFor(int pictureHeight) {
    int side = kSmallestSide;
    while (side < 2 * pictureHeight && side < kLargestSide) {
        side *= 2;
    }
    return side;
}

/// The box around a sphere, in steps of its texels that stand still in the world.
SunCascade boxAround(const Sphere& sphere, const glm::dmat3& sunFromWorld, int side) {
    const double step =
        std::ceil(kStepsPerOctave * std::log2(std::max(sphere.radius, 0.5 * side * kFinestTexel)));
    const double radius = std::exp2(step / kStepsPerOctave);
    SunCascade cascade;
    cascade.halfSide = radius * side / double(side - 2 * (kSunMapMargin + 1));
    const double texel = 2.0 * cascade.halfSide / side;
    cascade.middle =
        glm::round((sunFromWorld * sphere.centre - glm::dvec3(0, 0, cascade.halfSide)) / texel) *
        texel;
    return cascade;
}

/// Whether a box, in the sun's frame, may cast a shadow into the cascade's.
bool castsInto(const SunCascade& cascade, const Bounds& box) {
    return box.low.x <= cascade.middle.x + cascade.halfSide &&
           box.high.x >= cascade.middle.x - cascade.halfSide &&
           box.low.y <= cascade.middle.y + cascade.halfSide &&
           box.high.y >= cascade.middle.y - cascade.halfSide && box.high.z >= cascade.middle.z;
}

glm::dmat4 clipFromWorld(const SunCascade& cascade, const glm::dmat3& sunFromWorld) {
    const glm::dvec3 scale(1.0 / cascade.halfSide, 1.0 / cascade.halfSide, 1.0 / cascade.topMetres);
    glm::dmat4 clip(1.0);
    for (int i = 0; i < 3; ++i) {
        clip[i] = glm::dvec4(scale * sunFromWorld[i], 0.0);
    }
    clip[3] = glm::dvec4(-scale * cascade.middle, 1.0);
    return clip;
}

SunMapKey keyOf(const Scene& scene, const std::vector<DrawItem>& draws, const SunCascade& cascade) {
    SunMapKey key{cascade.clipFromWorld, {}};
    for (const int caster : cascade.casters) {
        key.casters.push_back(placeOf(scene, draws, caster));
    }
    return key;
}

/// What casts shadows, in the sun's frame.
struct Caster {
    int draw = 0;
    Bounds box;
};

/// False where nothing casts into it.
bool giveCasters(const std::vector<Caster>& casters, const glm::dmat3& sunFromWorld,
                 SunCascade& cascade) {
    for (const Caster& caster : casters) {
        if (castsInto(cascade, caster.box)) {
            cascade.casters.push_back(caster.draw);
            cascade.topMetres = std::max(cascade.topMetres, caster.box.high.z - cascade.middle.z);
        }
    }
    // A little more, so that the highest caster is not cut by rounding.
    cascade.topMetres += std::max(1e-3 * cascade.topMetres, 2.0 * cascade.halfSide * 1e-3);
    cascade.clipFromWorld = clipFromWorld(cascade, sunFromWorld);
    return !cascade.casters.empty();
}

}  // namespace

int SunShadowWork::drawn() const {
    return int(std::count_if(cascades.begin(), cascades.end(),
                             [](const SunCascade& cascade) { return !cascade.kept; }));
}

bool sunIsUp(const SkyDrawing& sky) {
    const double radius = sky.air.groundRadiusMetres;
    const double height = sky.altitudeMetres;
    const double dip = std::atan2(std::sqrt(height * (2.0 * radius + height)), radius);
    return sky.air.sunIlluminanceLux != glm::dvec3(0.0) &&
           std::asin(std::clamp(sky.towardsSun.y, -1.0, 1.0)) + sky.air.sunAngularRadius > -dip;
}

std::optional<SunShadowWork> planSunShadow(const Scene& scene, const SkyDrawing& sky,
                                           const Camera& camera, int width, int height,
                                           const std::vector<DrawItem>& draws,
                                           const std::vector<bool>& visible,
                                           const SunShadowCache& cache) {
    Bounds seen;
    for (std::size_t i = 0; i < draws.size(); ++i) {
        if (visible[i]) {
            seen.add(draws[i].worldBounds);
        }
    }
    if (seen.isEmpty() || !sunIsUp(sky)) {
        return std::nullopt;
    }
    SunShadowWork work;
    work.sunFromWorld = turnTowards(sky.towardsSun);
    work.side = sideFor(height);
    std::vector<Caster> casters;
    for (std::size_t i = 0; i < draws.size(); ++i) {
        if (castsShadow(scene, draws[i])) {
            casters.push_back({int(i), inSunFrame(work.sunFromWorld, draws[i].worldBounds)});
        }
    }
    const Depths depths = depthsOf(camera, seen);
    if (depths.farthest <= 0.0 || depths.farthest < depths.nearest) {
        return std::nullopt;
    }
    const glm::dvec2 half = viewHalfExtent(camera, width, height);
    const Sphere all{seen.centre(), glm::length(seen.halfSize())};
    double start = depths.nearest;
    for (const double end : splitDepths(camera, depths)) {
        const Sphere slice = aroundSlice(camera, half, {start, end});
        if (2.0 * slice.radius < work.side * kFinestTexel && end < depths.farthest) {
            continue;  // with the next
        }
        const bool holdsAll = all.radius <= slice.radius;
        SunCascade cascade = boxAround(holdsAll ? all : slice, work.sunFromWorld, work.side);
        if (giveCasters(casters, work.sunFromWorld, cascade)) {
            work.castersCulled += int(casters.size() - cascade.casters.size());
            gatherInstances(scene, draws, cascade.casters);
            work.cascades.push_back(std::move(cascade));
        }
        if (holdsAll) {
            break;
        }
        start = end;
    }
    if (work.cascades.empty()) {
        return std::nullopt;
    }
    const bool reuse = cache.side == work.side && work.cascades.size() <= cache.layers.size();
    work.layers = int(reuse ? cache.layers.size() : work.cascades.size());
    for (std::size_t i = 0; reuse && i < work.cascades.size(); ++i) {
        work.cascades[i].kept = cache.layers[i] == keyOf(scene, draws, work.cascades[i]);
    }
    return work;
}

void keepForNextFrame(const Scene& scene, const std::vector<DrawItem>& draws,
                      const SunShadowWork& work, SunShadowCache& cache) {
    if (cache.side != work.side || int(cache.layers.size()) != work.layers) {
        cache.side = work.side;
        cache.layers.assign(std::size_t(work.layers), std::nullopt);
    }
    for (std::size_t i = 0; i < work.cascades.size(); ++i) {
        if (!work.cascades[i].kept) {
            cache.layers[i] = keyOf(scene, draws, work.cascades[i]);
        }
    }
}

}  // namespace ribalta
