// A look as the settings of a frame.
#pragma once

#include "look/look.h"
#include "render/frame_settings.h"
#include "render/sky_settings.h"
#include "scene/scene.h"

namespace ribalta {

/// Where the sun stands without a directional lamp and without a word: 30 degrees high in the
/// southeast.
SunInSky sunOfNoLamp();

/// The sky of a look over a scene, whose first directional lamp is the sun where none is said.
SkyDrawing skyDrawing(const SkyLook& sky, const Scene& scene);

/// All that the look says of the picture but its size and camera.
FrameSettings frameSettings(const Look& look, const Scene& scene);

}  // namespace ribalta
