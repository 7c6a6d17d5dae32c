// The thesis's comparison of skies (Pinheiro 2014, chapter 6), to be repeated: its six viewpoints,
// the models in its configurations and ours, and its own figures.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reference/sky_sight.h"
#include "render/sky_settings.h"
#include "scene/camera.h"

namespace ribalta {

/// Degrees; azimuths from the sun's.
struct SkyViewpoint {
    const char* name;
    const char* says;
    double altitudeMetres;
    double pitch;  ///< of the view, above the horizontal
    double azimuth;
    double verticalFov;
    double sunElevation;  ///< over the horizontal at the eye
    double ev100;         ///< at which its pictures are shown
};
std::span<const SkyViewpoint> skyViewpoints();

/// What the thesis reports of a configuration, on a GeForce GTX 560.
struct ThesisSkyFigure {
    double kilobytes = 0.0;
    double ms = 0.0;  ///< of a frame, by its clock; for the sky without tables that of a call
};

/// A model in one configuration.
struct SkyRow {
    std::string name;
    std::string says;
    DrawnSky model;
    SkyOrders orders;  ///< that its light is held against
    bool rayleighOnly = false;
    std::optional<ThesisSkyFigure> thesis;
};
const std::vector<SkyRow>& skyRows();

/// From the scene's origin.
Camera cameraOf(const SkyViewpoint& view);
SkyDrawing drawingOf(const SkyViewpoint& view, const SkyRow& row);
/// The sky that the row's model stands for; `whole`: with haze and every order, whatever the model
/// leaves out.
SkyOverScene truthOf(const SkyViewpoint& view, const SkyRow& row, bool whole);

}  // namespace ribalta
