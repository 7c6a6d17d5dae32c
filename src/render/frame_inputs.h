// FrameInputs: all that a frame's picture depends on and that may change between frames. Geometry,
// images and materials that no animation changes are not in it: they are read once, when a scene is
// uploaded.
#pragma once

#include <cstdint>
#include <vector>

#include "render/frame_settings.h"
#include "scene/camera.h"
#include "scene/scene.h"

namespace ribalta {

struct FrameInputs {
    Camera camera;
    FrameSettings settings;
    std::vector<SpotLight> spotLights;
    std::vector<PointLight> pointLights;
    std::vector<DirectionalLight> directionalLights;
    std::vector<glm::dmat4> worldFromLocal;  ///< by node
    std::vector<bool> isDrawn;               ///< by node
    std::vector<std::uint64_t> shapes;       ///< by deformer
    std::vector<glm::dvec4> materials;       ///< by dial of materials

    /// Equal inputs give the same picture, value by value.
    bool operator==(const FrameInputs&) const = default;
};

/// The numbers of the scene's dials of materials, in their order.
std::vector<glm::dvec4> materialNumbers(const Scene& scene);

FrameInputs frameInputs(const Scene& scene, const Camera& camera, const FrameSettings& settings);

}  // namespace ribalta
