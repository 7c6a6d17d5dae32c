// Beams by the double-precision reference for every pixel of a picture, and how far the GPU's are
// from them.
#pragma once

#include <functional>
#include <vector>

#include <glm/glm.hpp>

#include "gpu_test.h"
#include "reference/integrate_beams.h"
#include "scene/scene.h"

namespace ribalta::test {

/// Metres along a ray to what ends it; infinity where nothing does.
using RayEnd = std::function<double(const glm::dvec3& origin, const glm::dvec3& direction)>;

/// The first crossing of the plane y = 0.
double floorEnd(const glm::dvec3& origin, const glm::dvec3& direction);
/// Nothing ends a ray.
double openEnd(const glm::dvec3& origin, const glm::dvec3& direction);

/// A picture of values, rows from the top.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<glm::dvec3> pixels;

    glm::dvec3& at(int x, int y) {
        return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    }
};

/// The scene's beams as the reference has them, one ray through each pixel's centre.
Picture referenceBeams(const Scene& scene, const Camera& camera, const FrameSettings& settings,
                       const RayEnd& end, const LampVisibility& isVisible = nullptr,
                       double relativeAccuracy = 1e-5);

/// The scene's beams as the GPU draws them.
Picture drawnBeams(const Scene& scene, const Camera& camera, const FrameSettings& settings);

/// sqrt(sum |a - b|^2 / sum |b|^2) over pixels and channels.
double relativeRmse(const Picture& a, const Picture& b);

}  // namespace ribalta::test
