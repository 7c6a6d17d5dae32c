#include "render/read_shadow_maps.h"

#include "render/gpu_frame.h"
#include "render/lamp_reach.h"

namespace ribalta {

std::vector<ShadowMapImage> readShadowMaps(const Renderer& renderer, const Scene& scene) {
    const FramePlan& plan = renderer.lastPlan();
    std::vector<ShadowMapImage> images;
    for (const PlannedLamp& planned : plan.lamps) {
        if (planned.shadowLayer < 0) {
            continue;
        }
        ShadowMapImage image;
        image.spot = planned.spot;
        image.side = plan.shadowMaps.side;
        // The map's own projection: the lamp's clip space with the lamp's place taken out.
        SpotLight atOrigin = scene.spotLights[std::size_t(planned.spot)];
        atOrigin.frame = {};
        const glm::dmat4 clipFromLamp =
            shadowClipFromWorld(atOrigin, image.side) * glm::inverse(lampFromWorld(atOrigin));
        image.inverseTan = clipFromLamp[0][0];
        image.nearMetres = clipFromLamp[3][2];
        image.depths.resize(std::size_t(image.side) * std::size_t(image.side));
        renderer.shadowMaps().readLayer(planned.shadowLayer, GL_DEPTH_COMPONENT, GL_FLOAT,
                                        std::as_writable_bytes(std::span(image.depths)));
        images.push_back(std::move(image));
    }
    return images;
}

}  // namespace ribalta
