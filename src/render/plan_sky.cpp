#include "render/plan_sky.h"

#include <algorithm>
#include <cmath>

namespace ribalta {

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

SkyWork planSky(const SkyDrawing& sky, const Bounds& scene, const Camera& camera, bool surfaces,
                const SkyCache& cache) {
    SkyWork work;
    work.drawing = sky;
    work.eye = skyEye(sky, camera.frame.position);
    work.haze = scene;
    work.aerial = surfaces;
    for (int i = 0; i < 8 && !scene.isEmpty(); ++i) {
        work.farthestMetres =
            std::max(work.farthestMetres, glm::distance(camera.frame.position, scene.corner(i)));
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
