#include "render/plan_sky.h"

#include <algorithm>
#include <cmath>

namespace ribalta {

namespace {

// Haze machines serve a stage, not the hills behind it: as far as lamps mostly reach.
constexpr double kHazeReachMetres = 40.0;

Bounds hazeBox(const Scene& scene, const Bounds& all) {
    Bounds box;
    for (const SpotLight& lamp : scene.spotLights) {
        const double reach = std::min(lamp.rangeMetres, kHazeReachMetres);
        box.add(lamp.frame.position);
        box.add(lamp.frame.position + reach * lamp.frame.forward());
    }
    if (!all.isEmpty() && !box.isEmpty()) {
        box.low = glm::clamp(box.low, all.low, all.high);
        box.high = glm::clamp(box.high, all.low, all.high);
    }
    return box;
}

}  // namespace

SkyEye skyEye(const SkyDrawing& sky, const glm::dvec3& position) {
    // Relative to the ground's point below the origin; no two large numbers are subtracted.
    const double radius = sky.air.groundRadiusMetres;
    const glm::dvec3 place = position + glm::dvec3(0.0, sky.altitudeMetres, 0.0);
    const double square = glm::dot(place, place) + 2.0 * radius * place.y;
    const glm::dvec3 fromCentre = place + glm::dvec3(0.0, radius, 0.0);
    const double height = square / (std::sqrt(std::max(radius * radius + square, 0.0)) + radius);
    SkyEye eye;
    eye.heightMetres = std::max(height, 0.0);
    eye.belowMetres = std::max(-height, 0.0);
    const double size = glm::length(fromCentre);
    eye.zenith = size > 0.0 ? fromCentre / size : eye.zenith;
    eye.muS = std::clamp(glm::dot(eye.zenith, sky.towardsSun), -1.0, 1.0);
    return eye;
}

SkyWork planSky(const SkyDrawing& sky, const Scene& scene, const Camera& camera, bool surfaces,
                const SkyCache& cache) {
    const Bounds bounds = sceneBounds(scene);
    SkyWork work;
    work.drawing = sky;
    work.eye = skyEye(sky, camera.frame.position);
    work.haze = hazeBox(scene, bounds);
    work.aerial = surfaces;
    for (int i = 0; i < 8 && !bounds.isEmpty(); ++i) {
        work.farthestMetres =
            std::max(work.farthestMetres, glm::distance(camera.frame.position, bounds.corner(i)));
    }
    work.makeTables = cache.air != sky.air || cache.orders != sky.orders;
    work.makeView = work.makeTables || cache.view != work.viewKey();
    return work;
}

void keepForNextFrame(const SkyWork& work, SkyCache& cache) {
    cache.air = work.drawing.air;
    cache.orders = work.drawing.orders;
    cache.view = work.viewKey();
}

}  // namespace ribalta
