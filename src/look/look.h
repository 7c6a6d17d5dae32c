// Look: how a scene is seen and what is changed of its lamps, kept apart from the scene's own file.
// Plain data.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "render/frame_settings.h"
#include "scene/camera.h"
#include "scene/frame.h"
#include "scene/haze.h"
#include "sky/sun_position.h"

namespace ribalta {

struct LightMapChange {
    /// None: the picture that the scene gives the lamp. Empty: no picture.
    std::optional<std::filesystem::path> file;
    std::optional<double> rotationRadians;  ///< counter-clockwise seen from the lamp

    bool operator==(const LightMapChange&) const = default;
};

/// What is changed of one lamp; what is not set stays as the scene has it.
struct LampChange {
    std::string name;
    int number = 0;  ///< which of the lamps of that name, counted from 0
    bool off = false;
    bool solo = false;                     ///< where any lamp is, only those shine
    std::optional<double> intensity;       ///< candela; lux where the lamp is directional; >= 0
    std::optional<glm::vec3> color;        ///< linear, >= 0
    std::optional<double> innerConeAngle;  ///< radians, half angle; spots only
    std::optional<double> outerConeAngle;
    std::optional<Frame> frame;  ///< world; takes the place of the scene's, animated or not
    LightMapChange lightMap;     ///< spots only

    bool operator==(const LampChange&) const = default;
    /// Whether it changes nothing.
    bool isIdle() const;
};

/// The sky over a look; what else can be set of its models stays at their defaults.
struct SkyLook {
    SkyKind model = SkyKind::kAuto;
    std::optional<SunInSky> sun;  ///< none: where the scene's first directional lamp shines from
    double altitudeMetres = 0.0;

    bool operator==(const SkyLook&) const = default;
};

/// The moment of a scene's animations.
struct LookTime {
    double seconds = 0.0;
    std::string animation;  ///< its name; empty: all together

    bool operator==(const LookTime&) const = default;
};

struct Look {
    std::string scene;               ///< name of the file that it was made for
    std::optional<Camera> camera;    ///< none: the scene's first, or one that frames it
    std::vector<Camera> bookmarks;   ///< views of one's own, by name
    std::optional<glm::ivec2> size;  ///< pixels
    std::optional<LookTime> time;    ///< none: at rest
    std::vector<LampChange> lamps;
    Haze haze;
    BeamSettings beams;
    std::optional<SkyLook> sky;
    double ambientLux = 1.0;
    std::optional<double> ev100;  ///< none: found from the picture
    ToneCurve toneCurve = ToneCurve::kNeutral;

    bool operator==(const Look&) const = default;
};

}  // namespace ribalta
