// The reference integral along the rays of a picture's pixels, on all cores.
#include "reference_beams.h"

#include <cmath>
#include <limits>

#include "base/parallel_for.h"
#include "support/stage.h"

namespace ribalta::test {

double floorEnd(const glm::dvec3& origin, const glm::dvec3& direction) {
    const double t = -origin.y / direction.y;
    return t > 0.0 ? t : std::numeric_limits<double>::infinity();
}

double openEnd(const glm::dvec3& /*origin*/, const glm::dvec3& /*direction*/) {
    return std::numeric_limits<double>::infinity();
}

Picture referenceBeams(const Scene& scene, const Camera& camera, const FrameSettings& settings,
                       const RayEnd& end, const LampVisibility& isVisible,
                       double relativeAccuracy) {
    const BeamIntegrator integrator(
        scene.spotLights, scene.images, settings.haze,
        isVisible ? std::make_unique<ProbedVisibility>(isVisible) : nullptr, relativeAccuracy);
    Picture picture{
        settings.width, settings.height,
        std::vector<glm::dvec3>(std::size_t(settings.width) * std::size_t(settings.height))};
    const double pixel =
        2.0 * viewHalfExtent(camera, settings.width, settings.height).y / settings.height;
    parallelFor(std::size_t(settings.height), [&](std::size_t y) {
        for (int x = 0; x < settings.width; ++x) {
            const PixelRay ray = pixelRay(camera, settings.width, settings.height, x, int(y));
            const double last = end(ray.origin, ray.direction);
            const double first = camera.nearMetres * ray.metresPerDepth;
            const double farthest = camera.farMetres * ray.metresPerDepth;
            if (first < last) {
                BeamRay beamRay{ray.origin, ray.direction, first, std::min(last, farthest)};
                (camera.isOrthographic() ? beamRay.width : beamRay.widening) = pixel;
                picture.at(x, int(y)) = integrator.along(beamRay).value;
            }
        }
    });
    return picture;
}

Picture drawnBeams(const Scene& scene, const Camera& camera, const FrameSettings& settings) {
    FrameLayers layers;
    layers.beams = true;
    const Frame3 frame = drawOnce(scene, camera, settings, layers);
    Picture picture{settings.width, settings.height, {}};
    for (int y = 0; y < settings.height; ++y) {
        for (int x = 0; x < settings.width; ++x) {
            picture.pixels.push_back(frame.color(x, y, "beams"));
        }
    }
    return picture;
}

double relativeRmse(const Picture& a, const Picture& b) {
    double difference = 0.0;
    double size = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const glm::dvec3 off = a.pixels[i] - b.pixels[i];
        difference += glm::dot(off, off);
        size += glm::dot(b.pixels[i], b.pixels[i]);
    }
    return std::sqrt(difference / size);
}

}  // namespace ribalta::test
