// The shadow maps of the last frame back in memory.
#pragma once

#include <vector>

#include "render/renderer.h"

namespace ribalta {

/// What one spot sees of its casters.
struct ShadowMapImage {
    int spot = 0;             ///< into Scene::spotLights
    int side = 0;             ///< texels
    double inverseTan = 1.0;  ///< 1 / tan of the map's half angle
    double nearMetres = 0.0;
    std::vector<float>
        depths;  ///< reversed (near / z, 0 where nothing is), rows along the lamp's up
};

/// Those of all spots that have one in the renderer's last frame. Waits for the GPU.
std::vector<ShadowMapImage> readShadowMaps(const Renderer& renderer, const Scene& scene);

}  // namespace ribalta
