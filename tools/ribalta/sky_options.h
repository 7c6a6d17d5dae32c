// The options that say which sky a scene stands under.
#pragma once

#include <optional>
#include <string>

#include "atmosphere_options.h"
#include "look/look.h"
#include "render/sky_settings.h"
#include "scene/scene.h"
#include "sky/sky_eye.h"
#include "sky_model_options.h"
#include "sun_time_options.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace ribalta {

/// The texts of --sky, --sun, --altitude, --sky-orders, of what belongs to one model of the sky and
/// of what the air is.
/// Must outlive the parsing of the command it is added to.
struct SkyOptions {
    std::string sky = "none";
    SkyModelOptions models;
    std::optional<std::string> sun;
    SunTimeOptions sunTime;
    std::optional<double> altitude;
    std::optional<int> orders;
    AtmosphereOptions atmosphere;

    void addTo(CLI::App& command);
    /// Of a command that has no sky but the renderer's own model, as a reference, and none of the
    /// options of other models.
    void addReferenceTo(CLI::App& command);

    /// Takes from a look's sky, where it has one, what was not given.
    void fillFrom(const std::optional<SkyLook>& look);
    /// What they mean for a scene; none: no sky. Says on stderr which sun is taken where it was not
    /// said. Throws CLI::ValidationError that says what was expected.
    std::optional<SkyDrawing> parsed(const Scene& scene) const;
    /// The same checks without a scene.
    void check() const;

  private:
    CLI::Option* skyOption_ = nullptr;
    std::optional<SunInSky> sunOfLook_;

    void addPlaceTo(CLI::App& command);
    DrawnSky model() const;
    std::optional<SunInSky> sunAsked() const;
    void tellOfSun(const Scene& scene) const;
};

/// Says on stderr that a camera is below the planet's ground, where it is.
void warnIfBelowGround(const SkyEye& eye);

}  // namespace ribalta
