// SkyWork: what a frame does for its sky, as data. Made on the CPU without OpenGL.
#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "render/frame_settings.h"
#include "scene/camera.h"
#include "scene/scene.h"
#include "sky/sky_eye.h"

namespace ribalta {

SkyEye skyEye(const SkyDrawing& sky, const glm::dvec3& position);

/// What the air leaves of light, per channel, on its way between two points of the scene at most
/// some 100 km apart.
glm::dvec3 transmittanceBetween(const SkyDrawing& sky, const glm::dvec3& from,
                                const glm::dvec3& to);

/// What the sky's table of a view was made for.
struct SkyViewKey {
    Atmosphere air;
    SkyOrders orders;
    double heightMetres = 0.0;
    double muS = 1.0;

    bool operator==(const SkyViewKey&) const = default;
};

/// What the table of the air before surfaces was made for.
struct AerialKey {
    Camera camera;
    int width = 0;
    int height = 0;
    SkyDrawing drawing;
    double farthestMetres = 0.0;

    bool operator==(const AerialKey&) const = default;
};

/// What earlier frames left behind that this one may use.
struct SkyCache {
    std::optional<Atmosphere> air;  ///< of the tables that are there
    SkyOrders orders;
    DrawnSky model;
    std::optional<SkyViewKey> view;
    std::optional<AerialKey> aerial;
};

struct SkyWork {
    SkyDrawing drawing;
    SkyEye eye;
    bool makeTables = true;   ///< those of the air
    bool makeView = true;     ///< what is seen from the eye's height; the renderer's own model's
    bool edges = false;       ///< the planet's shadow may be in view, whose edges that table blurs
    bool aerial = false;      ///< there are surfaces to stand in the air
    bool makeAerial = false;  ///< the table of the air before them; the own model's too
    AerialKey aerialKey;      ///< farthest: from the eye to the end of the scene
    /// Its middle is that of the cloud of haze, its faces lie where that has thinned out to 1 / e.
    Bounds haze;

    /// Whether the model has tables of the air at all.
    bool hasTables() const { return !std::holds_alternative<ChapmanSky>(drawing.model); }
    SkyViewKey viewKey() const { return {drawing.air, drawing.orders, eye.heightMetres, eye.muS}; }
};

SkyWork planSky(const Scene& scene, const Camera& camera, const FrameSettings& settings,
                bool surfaces, const SkyCache& cache);
void keepForNextFrame(const SkyWork& work, SkyCache& cache);

}  // namespace ribalta
