// FrameInputs: all that a frame's picture depends on and that may change between frames. Geometry,
// materials and images are not in it: they are read once, when a scene is uploaded.
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
    std::vector<std::uint64_t> shapes;       ///< by deformer

    /// Equal inputs give the same picture, value by value.
    bool operator==(const FrameInputs&) const = default;
};

FrameInputs frameInputs(const Scene& scene, const Camera& camera, const FrameSettings& settings);

}  // namespace ribalta
