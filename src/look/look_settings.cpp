#include "look/look_settings.h"

#include <numbers>

namespace ribalta {
namespace {

DrawnSky drawnSky(SkyKind kind) {
    switch (kind) {
        case SkyKind::kBruneton:
            return PrecomputedSkySettings{};
        case SkyKind::kSingle:
            return simplifiedSky();
        case SkyKind::kChapman:
            return ChapmanSky{};
        case SkyKind::kAuto:
            break;
    }
    return OwnSky{};
}

}  // namespace

SunInSky sunOfNoLamp() {
    return {std::numbers::pi / 6.0, 0.75 * std::numbers::pi};
}

SkyDrawing skyDrawing(const SkyLook& sky, const Scene& scene) {
    SkyDrawing drawing;
    drawing.model = drawnSky(sky.model);
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
    settings.toneCurve = look.toneCurve;
    if (look.sky) {
        settings.sky = skyDrawing(*look.sky, scene);
    }
    return settings;
}

}  // namespace ribalta
