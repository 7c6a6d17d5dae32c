// FramePlan: what one frame will draw, as data. Made on the CPU without OpenGL; what a frame does
// not need is not in its plan, and so no pass, shader or texture is made for it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "render/beam_tiles.h"
#include "render/draw_list.h"
#include "render/frame_settings.h"
#include "render/plan_lamps.h"
#include "render/plan_sky.h"
#include "render/plan_sun_shadow.h"
#include "scene/camera.h"
#include "scene/scene.h"

namespace ribalta {

/// Everything a shadow map's content depends on.
struct ShadowKey {
    Frame frame;
    double halfAngle = 0.0;
    double rangeMetres = 0.0;
    int side = 0;  ///< texels
    std::vector<DrawPlace> casters;

    bool operator==(const ShadowKey& other) const;
};

/// What the frame before left behind that this one may use.
struct FrameCache {
    int shadowSide = 0;                                  ///< texels of the maps that are there
    std::vector<std::optional<ShadowKey>> shadowLayers;  ///< by layer
    std::vector<bool> pyramidLayers;                     ///< by layer: its pyramid is of this map
    SkyCache sky;
    SunShadowCache sunShadow;
    std::vector<std::uint64_t> shapes;  ///< by deformer: what it was drawn as; 0: not yet
};

/// One lamp's shadow map to draw.
struct ShadowMapWork {
    int layer = 0;
    int spot = 0;              ///< into Scene::spotLights
    std::vector<int> casters;  ///< into FramePlan::draws
};

/// The layers the frame's shadow maps live in.
struct ShadowMaps {
    int side = 0;  ///< texels
    int layers = 0;
};

/// A spot that reaches the view.
struct PlannedLamp {
    int spot = 0;          ///< into Scene::spotLights
    int shadowLayer = -1;  ///< -1: nothing stands in its beam
};

struct ForwardWork {
    std::vector<int> opaque;   ///< into FramePlan::draws, near to far but for instances
    std::vector<int> blended;  ///< far to near
    bool normalOutput = false;
};

struct BeamsWork {
    BeamSettings settings;
    PhaseFunction::Kind phase = PhaseFunction::Kind::kGibbons;
    std::vector<int> lamps;       ///< into FramePlan::lamps
    BeamTiles tiles;              ///< all but planes; their lists index FramePlan::lamps
    glm::ivec2 latticePoints{0};  ///< adaptive only
    std::optional<double> ev100;  ///< adaptive only; none: found from the picture
    ToneCurve toneCurve = ToneCurve::kNeutral;  ///< adaptive only
    double firstDepth = 0.0;                    ///< planes only: metres along the view axis
    double spacingMetres = 0.0;                 ///< planes only
    double fullScale = 0.0;      ///< planes in eight bits only: cd/m2 of the highest code value
    bool shadowPyramid = false;  ///< runs of sheets are judged by it
    bool lightMaps = false;      ///< some lamp has one
    bool separateOutput = false;
    bool countRuns = false;
};

struct TonemapWork {
    std::optional<double> ev100;  ///< none: found from the picture
    ToneCurve curve = ToneCurve::kNeutral;
    std::optional<double> highestLux;  ///< of false colours instead
};

struct FramePlan {
    FrameSettings settings;
    Camera camera;
    std::vector<DrawItem> draws;
    std::vector<PlannedLamp> lamps;
    std::vector<int> pointLights;        ///< into Scene::pointLights
    std::vector<int> directionalLights;  ///< into Scene::directionalLights
    int lampsSkipped = 0;                ///< lamps of all kinds that do not reach the view
    SkippedLamps skipped;                ///< the same by reason
    int lampsWithoutShadow = 0;          ///< spots with casters for which no shadow map is left
    ShadowMaps shadowMaps;
    int shadowMapsNeedless = 0;  ///< spots in whose beam nothing stands that casts a shadow
    int castersDrawn = 0;        ///< in all shadow maps of the frame, kept ones included
    int castersCulled = 0;   ///< what casts shadows, but stands outside the cone of a map's lamp
    int shadowMapsKept = 0;  ///< as they were drawn for an earlier frame
    bool kept = false;       ///< the picture of the frame before: none of the passes below is run

    std::vector<int> deformWork;  ///< into Scene::deformers; empty: none, or none changed its shape
    int deformersKept = 0;        ///< drawn in the shape that they had in an earlier frame
    std::int64_t verticesDeformed = 0;

    std::vector<ShadowMapWork> shadowMapWork;  ///< empty: no lamp with casters, or all kept
    std::vector<int> shadowPyramidWork;        ///< layers; empty: not used, or all kept
    std::optional<ForwardWork> forward;        ///< absent: nothing to see
    std::optional<SkyWork> sky;                ///< absent: no sky is asked for
    std::optional<SunShadowWork> sunShadow;    ///< absent: no sun, or nothing casts
    std::optional<BeamsWork> beams;            ///< absent: clear air, or no beam in view
    std::optional<TonemapWork> tonemap;        ///< absent: no picture for a screen is asked for

    /// Turns the plan of a drawn frame into that of one that shows the same picture again.
    void keepPicture();
    /// One line, e.g. "shadow_map[12] forward beams[12] exposure tonemap"; "kept".
    std::string describe() const;
    /// Light samples the beams take, an upper bound known before drawing: sheets * pixels * lamps.
    std::uint64_t beamSamples() const;
    /// Squares of the picture that beams are drawn in, and all there are.
    int beamTilesDrawn() const;
    int beamTilesTotal() const;
    /// The spots of `lamps`, into Scene::spotLights.
    std::vector<int> spotsDrawn() const;
};

/// `lit`: where light maps let light through, where that is known.
FramePlan planFrame(const Scene& scene, const Camera& camera, const FrameSettings& settings,
                    const FrameCache& cache, const LitRegions& lit = {});

/// What the next frame may use once the plan is drawn.
void keepForNextFrame(const Scene& scene, const FramePlan& plan, FrameCache& cache);

}  // namespace ribalta
