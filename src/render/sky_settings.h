// SkyDrawing: which sky a frame has; the kinds of it by name.
#pragma once

#include <span>
#include <variant>

#include <glm/glm.hpp>

#include "base/names.h"
#include "render/baseline_sky_settings.h"
#include "scene/atmosphere.h"
#include "sky/sky_tables.h"

namespace ribalta {

enum class SkyKind { kAuto, kBruneton, kSingle, kChapman };

/// As on the command line and in looks; the renderer's own model first.
std::span<const Named<SkyKind>> skyKinds();

inline std::string_view name(SkyKind kind) {
    return nameIn(skyKinds(), kind);
}

/// The renderer's own model, `auto`.
struct OwnSky {
    bool operator==(const OwnSky&) const = default;
};
using DrawnSky = std::variant<OwnSky, PrecomputedSkySettings, ChapmanSky>;

struct SkyDrawing {
    Atmosphere air;
    SkyOrders orders;                      ///< of the renderer's own model
    DrawnSky model;                        ///< what draws it
    glm::dvec3 towardsSun{0.0, 1.0, 0.0};  ///< unit, world
    double altitudeMetres = 0.0;           ///< of the scene's origin above the ground, >= 0
    int sunLamp = -1;  ///< into Scene::directionalLights: the lamp that the sun takes the place of

    bool isOwn() const { return std::holds_alternative<OwnSky>(model); }
    bool operator==(const SkyDrawing&) const = default;
};

}  // namespace ribalta
