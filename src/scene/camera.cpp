#include "scene/camera.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace ribalta {

glm::dvec2 viewHalfExtent(const Camera& camera, int width, int height) {
    const double aspect = double(width) / double(height);
    if (const auto* lens = std::get_if<OrthographicLens>(&camera.lens)) {
        const double authored = lens->halfWidth / lens->halfHeight;
        return aspect >= authored ? glm::dvec2(lens->halfHeight * aspect, lens->halfHeight)
                                  : glm::dvec2(lens->halfWidth, lens->halfWidth / aspect);
    }
    const auto& lens = std::get<PerspectiveLens>(camera.lens);
    double halfHeight = std::tan(0.5 * lens.verticalFov);
    if (lens.aspectRatio && aspect < *lens.aspectRatio) {
        halfHeight *= *lens.aspectRatio / aspect;
    }
    return {halfHeight * aspect, halfHeight};
}

glm::dmat4 worldFromView(const Camera& camera) {
    const glm::dmat3& axes = camera.frame.worldFromLocal;
    return {glm::dvec4(axes[0], 0.0), glm::dvec4(axes[1], 0.0), glm::dvec4(axes[2], 0.0),
            glm::dvec4(camera.frame.position, 1.0)};
}

glm::dmat4 viewFromWorld(const Camera& camera) {
    const glm::dmat3 rotation = glm::transpose(camera.frame.worldFromLocal);
    glm::dmat4 view(rotation);
    view[3] = glm::dvec4(-(rotation * camera.frame.position), 1.0);
    return view;
}

glm::dmat4 clipFromWorld(const Camera& camera, int width, int height) {
    const glm::dvec2 half = viewHalfExtent(camera, width, height);
    const double n = camera.nearMetres;
    const double f = camera.farMetres;
    glm::dmat4 clip(0.0);
    clip[0][0] = 1.0 / half.x;
    clip[1][1] = 1.0 / half.y;
    if (camera.isOrthographic()) {
        CHECK(std::isfinite(f));
        // depth = (far - distance) / (far - near): 1 at near, 0 at far.
        clip[2][2] = 1.0 / (f - n);
        clip[3][2] = f / (f - n);
        clip[3][3] = 1.0;
    } else if (std::isinf(f)) {
        // depth = near / distance.
        clip[3][2] = n;
        clip[2][3] = -1.0;
    } else {
        clip[2][2] = n / (f - n);
        clip[3][2] = n * f / (f - n);
        clip[2][3] = -1.0;
    }
    return clip * viewFromWorld(camera);
}

Camera makeFramingCamera(const Bounds& bounds, double aspectRatio) {
    Camera camera;
    camera.name = "framing";
    const double verticalFov = 0.7;
    camera.lens = PerspectiveLens{verticalFov, std::nullopt};
    const glm::dvec3 centre = bounds.isEmpty() ? glm::dvec3(0.0) : bounds.centre();
    const double radius = bounds.isEmpty() ? 1.0 : std::max(1e-4, glm::length(bounds.halfSize()));
    const double halfHeight = std::tan(0.5 * verticalFov) * std::min(1.0, aspectRatio);
    const double distance = radius / std::sin(std::atan(halfHeight));
    const glm::dvec3 direction = glm::normalize(glm::dvec3(0.25, 0.25, 1.0));
    camera.frame = lookAt(centre + distance * direction, centre);
    camera.nearMetres = std::max(distance * 1e-3, distance - 1.5 * radius);
    return camera;
}

}  // namespace ribalta
