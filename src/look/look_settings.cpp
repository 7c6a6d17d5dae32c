#include "look/look_settings.h"

#include <numbers>

namespace ribalta {
namespace {

DrawnSky modelNamed(const std::string& name) {
    if (name == "bruneton") {
        return PrecomputedSkySettings{};
    }
    if (name == "single") {
        return simplifiedSky();
    }
    if (name == "chapman") {
        return ChapmanSky{};
    }
    return OwnSky{};
}

}  // namespace

SunInSky sunOfNoLamp() {
    return {std::numbers::pi / 6.0, 0.75 * std::numbers::pi};
}

SkyDrawing skyDrawing(const SkyLook& sky, const Scene& scene) {
    SkyDrawing drawing;
    drawing.model = modelNamed(sky.model);
    // Schuler's model has no haze.
    if (std::holds_alternative<ChapmanSky>(drawing.model)) {
        drawing.air = withoutMie(drawing.air);
    }
    drawing.altitudeMetres = sky.altitudeMetres;
    drawing.sunLamp = scene.directionalLights.empty() ? -1 : 0;
    if (sky.sun || drawing.sunLamp < 0) {
        drawing.towardsSun = towards(sky.sun.value_or(sunOfNoLamp()));
    } else {
        drawing.towardsSun = -scene.directionalLights.front().direction;
    }
    return drawing;
}

FrameSettings frameSettings(const Look& look, const Scene& scene) {
    FrameSettings settings;
    settings.haze = look.haze;
    settings.beams = look.beams;
    settings.ambientLux = look.ambientLux;
    settings.ev100 = look.ev100;
    if (look.sky) {
        settings.sky = skyDrawing(*look.sky, scene);
    }
    return settings;
}

}  // namespace ribalta
