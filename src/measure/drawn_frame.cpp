#include "measure/drawn_frame.h"

#include <utility>

#include "render/read_frame.h"
#include "render/read_shadow_maps.h"

namespace ribalta {

DrawnFrame drawForReference(Renderer& renderer, const Scene& scene,
                            const ReferenceSettings& reference) {
    FrameSettings settings;
    settings.width = reference.width;
    settings.height = reference.height;
    settings.haze = reference.haze;
    // Gibbons' factor of zero: the same frame in every way, but beams add nothing to it, so that
    // its colour is that of the surfaces to the last bit.
    settings.haze.phase = {PhaseFunction::Kind::kGibbons, 0.0, 0.0};
    settings.beams.method = BeamMethod::kClipped;
    settings.beams.planes = 1;
    settings.ambientLux = reference.ambientLux;
    settings.display = false;
    const FramePlan& plan = renderer.draw(reference.camera, settings);

    FrameLayers layers;
    layers.depth = true;
    const FloatImage image = readFrame(plan, renderer.targets(), layers);
    const int depth = image.channel("Z");
    DrawnFrame frame;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            frame.surfaces.emplace_back(image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2));
            frame.depths.push_back(image.at(x, y, depth));
        }
    }
    frame.shadowMaps.resize(scene.spotLights.size());
    for (ShadowMapImage& map : readShadowMaps(renderer, scene)) {
        frame.shadowMaps[std::size_t(map.spot)] =
            DrawnShadowMap{map.side, map.inverseTan, map.nearMetres, std::move(map.depths)};
    }
    return frame;
}

}  // namespace ribalta
