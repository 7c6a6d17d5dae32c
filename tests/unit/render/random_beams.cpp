// Lamps, cameras and points by a fixed random sequence; projections written out without matrices.
#include "random_beams.h"

#include <cmath>
#include <numbers>

namespace ribalta::test {

double RandomBeams::between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
}

glm::dvec3 RandomBeams::inCube(double halfSide) {
    const double x = between(-halfSide, halfSide);
    const double y = between(-halfSide, halfSide);
    return {x, y, between(-halfSide, halfSide)};
}

glm::dvec3 RandomBeams::direction() {
    const double z = between(-1.0, 1.0);
    const double around = between(0.0, 2.0 * std::numbers::pi);
    const double ring = std::sqrt(1.0 - z * z);
    return {ring * std::cos(around), ring * std::sin(around), z};
}

SpotLight RandomBeams::lamp() {
    SpotLight lamp;
    const glm::dvec3 position = inCube(10.0);
    lamp.frame = lookAt(position, position + direction(), direction());
    // Narrow beams are as likely as wide ones.
    lamp.outerConeAngle =
        kMinConeAngle * std::pow(kMaxConeAngle / kMinConeAngle, between(0.0, 1.0));
    lamp.beamShape = chance(0.3) ? BeamShape::kPyramid : BeamShape::kCone;
    if (chance(0.5)) {
        lamp.rangeMetres = between(0.5, 30.0);
    }
    return lamp;
}

Camera RandomBeams::camera(const SpotLight& lamp) {
    Camera camera;
    glm::dvec3 position = inCube(10.0);
    glm::dvec3 forward = direction();
    const double kind = between(0.0, 1.0);
    if (kind < 0.1) {
        position = lamp.frame.position;
    } else if (kind < 0.3) {
        position = pointInBeam(lamp, 10.0);
    } else if (kind < 0.4) {
        position = lamp.frame.position + between(-5.0, 5.0) * lamp.frame.forward();
        forward = lamp.frame.forward();
    } else if (kind < 0.5) {
        position = lamp.frame.position + between(0.5, 9.0) * lamp.frame.forward();
        forward = -lamp.frame.forward();
    }
    camera.frame = lookAt(position, position + forward, direction());
    camera.nearMetres = between(0.02, 0.5);
    if (chance(0.25)) {
        camera.lens = OrthographicLens{between(1.0, 10.0), between(1.0, 10.0)};
        camera.farMetres = between(20.0, 200.0);
    } else {
        camera.lens = PerspectiveLens{between(0.2, 2.2), std::nullopt};
        if (chance(0.3)) {
            camera.farMetres = between(20.0, 200.0);
        }
    }
    return camera;
}

glm::dvec3 RandomBeams::pointInBeam(const SpotLight& lamp, double farthest) {
    const double tangent = std::tan(lamp.outerConeAngle);
    glm::dvec2 slope;
    do {
        const double x = between(-1.0, 1.0);
        slope = tangent * glm::dvec2(x, between(-1.0, 1.0));
    } while (lamp.beamShape == BeamShape::kCone && glm::length(slope) > tangent);
    const double longest = std::sqrt(1.0 + glm::dot(slope, slope));
    const double end = std::min(farthest, lamp.rangeMetres / longest);
    // Near the apex as often as far from it.
    const double depth = end * std::pow(10.0, between(-3.0, 0.0));
    return lamp.frame.position + depth * (lamp.frame.forward() + slope.x * lamp.frame.right() +
                                          slope.y * lamp.frame.up());
}

std::optional<glm::dvec2> project(const Camera& camera, int width, int height,
                                  const glm::dvec3& point) {
    const glm::dvec3 to = point - camera.frame.position;
    const double depth = glm::dot(to, camera.frame.forward());
    if (depth < camera.nearMetres || depth > camera.farMetres) {
        return std::nullopt;
    }
    const glm::dvec2 half =
        viewHalfExtent(camera, width, height) * (camera.isOrthographic() ? 1.0 : depth);
    return glm::dvec2((glm::dot(to, camera.frame.right()) / half.x + 1.0) * 0.5 * width,
                      (glm::dot(to, camera.frame.up()) / half.y + 1.0) * 0.5 * height);
}

}  // namespace ribalta::test
