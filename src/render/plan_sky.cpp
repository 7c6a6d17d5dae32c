#include "render/plan_sky.h"

#include <algorithm>
#include <cmath>

#include "sky/sky_air.h"

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
    return skyEye(sky.air, sky.altitudeMetres, sky.towardsSun, position);
}

glm::dvec3 transmittanceBetween(const SkyDrawing& sky, const glm::dvec3& from,
                                const glm::dvec3& to) {
    const shader::Air air = airOf(sky.air);
    glm::dvec3 extinction(0.0);
    for (int i = 0; i < 3; ++i) {  // Simpson's rule
        const double height = skyEye(sky, glm::mix(from, to, 0.5 * i)).heightMetres;
        if (height <= air.top) {
            extinction += (i == 1 ? 4.0 : 1.0) / 6.0 * shader::airExtinction(air, height);
        }
    }
    return glm::exp(-extinction * glm::distance(from, to));
}

SkyWork planSky(const Scene& scene, const Camera& camera, const FrameSettings& settings,
                bool surfaces, const SkyCache& cache) {
    const Bounds bounds = sceneBounds(scene);
    SkyWork work;
    work.drawing = settings.sky.value();
    work.eye = skyEye(work.drawing, camera.frame.position);
    work.haze = hazeBox(scene, bounds);
    double farthest = 1.0;
    for (int i = 0; i < 8 && !bounds.isEmpty(); ++i) {
        farthest = std::max(farthest, glm::distance(camera.frame.position, bounds.corner(i)));
    }
    const bool own = work.drawing.isOwn();
    work.makeTables = cache.air != work.drawing.air || cache.model != work.drawing.model ||
                      (own && cache.orders != work.drawing.orders);
    work.makeView = own && (work.makeTables || cache.view != work.viewKey());
    work.edges = own && seesPlanetShadow(work.drawing.air, work.eye);
    work.aerial = surfaces;
    work.aerialKey = {camera, settings.width, settings.height, work.drawing, farthest};
    work.makeAerial = own && surfaces && (work.makeTables || cache.aerial != work.aerialKey);
    return work;
}

void keepForNextFrame(const SkyWork& work, SkyCache& cache) {
    cache.air = work.drawing.air;
    cache.orders = work.drawing.orders;
    cache.model = work.drawing.model;
    cache.view = work.viewKey();
    if (work.makeTables) {
        cache.aerial.reset();
    }
    if (work.makeAerial) {
        cache.aerial = work.aerialKey;
    }
}

}  // namespace ribalta
