#include "render/frame_plan.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/check.h"
#include "optics/shader_lib.h"
#include "render/lamp_reach.h"

namespace ribalta {
namespace {

// All shadow maps together: at most 192 MiB.
constexpr std::int64_t kShadowTexels = std::int64_t(48) << 20;
// Layers that every OpenGL 4.5 offers in one texture.
constexpr std::size_t kMaxShadowMaps = 2048;
constexpr int kMinShadowSide = 256;
constexpr int kMaxShadowSide = 2048;

// A scene without a floor or walls still has an end for the planes.
constexpr double kEmptySceneDepth = 100.0;

double depthOf(const Camera& camera, const glm::dvec3& point) {
    return glm::dot(camera.frame.forward(), point - camera.frame.position);
}

// At least a texel for two rows of the picture: a beam seldom fills more than half of it, and finer
// maps only cost memory traffic, which is what beams spend their time on.
int shadowSideFor(std::size_t lamps, int pictureHeight) {
    int side = kMinShadowSide;
    while (2 * side < pictureHeight && side < kMaxShadowSide) {
        side *= 2;
    }
    while (side > kMinShadowSide &&
           std::int64_t(side) * side * std::int64_t(lamps) > kShadowTexels) {
        side /= 2;
    }
    return side;
}

std::vector<int> castersOf(const Scene& scene, const FramePlan& plan, const SpotLight& lamp) {
    std::vector<int> casters;
    for (std::size_t i = 0; i < plan.draws.size(); ++i) {
        if (castsShadow(scene, plan.draws[i]) && beamTouches(lamp, plan.draws[i].worldBounds)) {
            casters.push_back(int(i));
        }
    }
    gatherInstances(scene, plan.draws, casters);
    return casters;
}

ShadowKey keyOf(const Scene& scene, const FramePlan& plan, const ShadowMapWork& work) {
    const SpotLight& lamp = scene.spotLights[std::size_t(work.spot)];
    ShadowKey key{lamp.frame, drawnConeAngle(lamp), lamp.rangeMetres, plan.shadowMaps.side, {}};
    for (const int caster : work.casters) {
        key.casters.push_back(placeOf(scene, plan.draws, caster));
    }
    return key;
}

// Gives every lamp with casters a layer: the one that already holds its map, or a free one.
void planShadowMaps(const Scene& scene, const FrameCache& cache, const LitRegions& lit,
                    FramePlan& plan) {
    const auto allCasters =
        int(std::count_if(plan.draws.begin(), plan.draws.end(),
                          [&](const DrawItem& item) { return castsShadow(scene, item); }));
    std::vector<ShadowMapWork> wanted;
    std::vector<std::size_t> lampOf;
    for (std::size_t i = 0; i < plan.lamps.size(); ++i) {
        const PlannedLamp& planned = plan.lamps[i];
        std::vector<int> casters =
            castersOf(scene, plan, litPart(scene.spotLights[std::size_t(planned.spot)], lit));
        if (casters.empty()) {
            ++plan.shadowMapsNeedless;
        } else if (wanted.size() == kMaxShadowMaps) {
            ++plan.lampsWithoutShadow;
        } else {
            plan.castersDrawn += int(casters.size());
            plan.castersCulled += allCasters - int(casters.size());
            wanted.push_back({-1, planned.spot, std::move(casters)});
            lampOf.push_back(i);
        }
    }
    if (wanted.empty()) {
        return;
    }
    // Maps that are there already are good enough while every lamp finds a place among them.
    const bool reuse = cache.shadowSide > 0 && wanted.size() <= cache.shadowLayers.size() &&
                       cache.shadowSide == shadowSideFor(wanted.size(), plan.settings.height);
    plan.shadowMaps.side =
        reuse ? cache.shadowSide : shadowSideFor(wanted.size(), plan.settings.height);
    plan.shadowMaps.layers = int(reuse ? cache.shadowLayers.size() : wanted.size());

    std::vector<bool> taken(std::size_t(plan.shadowMaps.layers), false);
    std::vector<bool> kept(wanted.size(), false);
    for (std::size_t w = 0; reuse && w < wanted.size(); ++w) {
        const ShadowKey key = keyOf(scene, plan, wanted[w]);
        for (std::size_t layer = 0; layer < cache.shadowLayers.size(); ++layer) {
            if (!taken[layer] && cache.shadowLayers[layer] && *cache.shadowLayers[layer] == key) {
                taken[layer] = true;
                kept[w] = true;
                wanted[w].layer = int(layer);
                break;
            }
        }
    }
    std::size_t free = 0;
    for (std::size_t w = 0; w < wanted.size(); ++w) {
        if (!kept[w]) {
            while (taken[free]) {
                ++free;
            }
            taken[free] = true;
            wanted[w].layer = int(free);
        }
        plan.lamps[lampOf[w]].shadowLayer = wanted[w].layer;
        if (kept[w]) {
            ++plan.shadowMapsKept;
        } else {
            plan.shadowMapWork.push_back(std::move(wanted[w]));
        }
    }
}

void planForward(const Scene& scene, const std::vector<bool>& visible, FramePlan& plan) {
    ForwardWork work;
    work.normalOutput = plan.settings.normalOutput;
    std::vector<double> depth(plan.draws.size());
    for (std::size_t i = 0; i < plan.draws.size(); ++i) {
        if (!visible[i]) {
            continue;
        }
        const Bounds& bounds = plan.draws[i].worldBounds;
        depth[i] = depthOf(plan.camera, bounds.centre());
        const bool blended = materialOf(scene, plan.draws[i]).isSeeThrough();
        // Light that falls on what is behind a veil cannot be shown with that on the veil.
        if (blended && plan.settings.illuminance) {
            continue;
        }
        (blended ? work.blended : work.opaque).push_back(int(i));
    }
    const auto nearer = [&](int a, int b) { return depth[std::size_t(a)] < depth[std::size_t(b)]; };
    std::stable_sort(work.opaque.begin(), work.opaque.end(), nearer);
    gatherInstances(scene, plan.draws, work.opaque);
    std::stable_sort(work.blended.begin(), work.blended.end(),
                     [&](int a, int b) { return nearer(b, a); });
    if (!work.opaque.empty() || !work.blended.empty()) {
        plan.forward = std::move(work);
    }
}

// The planes' places: from the near plane to the end of the scene; or, at a given distance from
// each other, around the middle of that.
void planPlanes(const Scene& scene, const FramePlan& plan, BeamsWork& work) {
    Bounds bounds = sceneBounds(scene);
    for (const PlannedLamp& lamp : plan.lamps) {
        bounds.add(scene.spotLights[std::size_t(lamp.spot)].frame.position);
    }
    double end = plan.camera.nearMetres;
    for (int i = 0; i < 8 && !bounds.isEmpty(); ++i) {
        end = std::max(end, depthOf(plan.camera, bounds.corner(i)));
    }
    end = end > plan.camera.nearMetres ? end : plan.camera.nearMetres + kEmptySceneDepth;
    end = std::min(end, plan.camera.farMetres);
    if (work.settings.eightBitBlending) {
        CHECK(plan.settings.ev100.has_value());
        work.fullScale = 1.0 / shader::exposureFromEv100(*plan.settings.ev100);
    }
    const double near = plan.camera.nearMetres;
    work.firstDepth = near;
    work.spacingMetres = (end - near) / work.settings.planes;
    if (work.settings.spacingMetres) {
        work.spacingMetres = *work.settings.spacingMetres;
        const double length = work.spacingMetres * work.settings.planes;
        work.firstDepth = std::max(near, 0.5 * (near + end - length));
    }
}

// A lattice point every few pixels, and where beams are too thin for that, every pixel.
void planLattice(const Scene& scene, const FramePlan& plan, BeamsWork& work) {
    constexpr double kThin = 3.0 * gpu::kLatticeStep;  // pixels
    const int width = plan.settings.width;
    const int height = plan.settings.height;
    work.latticePoints = (glm::ivec2(width, height) + gpu::kLatticeStep - 1) / gpu::kLatticeStep;
    work.ev100 = plan.settings.ev100;
    work.toneCurve = plan.settings.toneCurve;
    std::vector<std::vector<glm::dvec2>> outlines;
    for (const int lamp : work.lamps) {
        const int spot = plan.lamps[std::size_t(lamp)].spot;
        outlines.push_back(thinBeamOutline(scene.spotLights[std::size_t(spot)], plan.camera, width,
                                           height, kThin));
    }
    markThinBeams(outlines, width, height, work.tiles);
}

// Where there are many sheets, and of shadow maps those whose pyramid is not that of an earlier
// frame.
void planShadowPyramid(const FrameCache& cache, FramePlan& plan, BeamsWork& work) {
    if (work.settings.planes < work.settings.sheetsForPyramid) {
        return;
    }
    for (const int lamp : work.lamps) {
        const int layer = plan.lamps[std::size_t(lamp)].shadowLayer;
        if (layer < 0) {
            continue;
        }
        work.shadowPyramid = true;
        const bool redrawn =
            std::any_of(plan.shadowMapWork.begin(), plan.shadowMapWork.end(),
                        [&](const ShadowMapWork& map) { return map.layer == layer; });
        if (redrawn || std::size_t(layer) >= cache.pyramidLayers.size() ||
            !cache.pyramidLayers[std::size_t(layer)]) {
            plan.shadowPyramidWork.push_back(layer);
        }
    }
}

void planBeams(const Scene& scene, const std::vector<std::vector<glm::dvec2>>& outlines,
               const FrameCache& cache, FramePlan& plan) {
    BeamsWork work;
    work.settings = plan.settings.beams;
    work.phase = plan.settings.haze.phase.kind;
    work.separateOutput = plan.settings.beamsOutput;
    work.countRuns = plan.settings.countRuns;
    work.tiles = makeBeamTiles(
        outlines, plan.settings.width, plan.settings.height,
        work.settings.method == BeamMethod::kAdaptive ? gpu::kLatticeTileSide : gpu::kTileSide);
    if (work.tiles.tiles.empty()) {
        return;
    }
    std::vector<bool> seen(plan.lamps.size(), false);
    for (const int lamp : work.tiles.lamps) {
        seen[std::size_t(lamp)] = true;
    }
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (seen[i]) {
            work.lamps.push_back(int(i));
        }
    }
    work.lightMaps = std::any_of(work.lamps.begin(), work.lamps.end(), [&](int lamp) {
        const int spot = plan.lamps[std::size_t(lamp)].spot;
        return scene.spotLights[std::size_t(spot)].lightMap.has_value();
    });
    if (work.settings.method == BeamMethod::kPlanes) {
        planPlanes(scene, plan, work);
        work.tiles = {};
    } else if (work.settings.method == BeamMethod::kMarch) {
        work.tiles = oneLampEach(work.tiles);
    } else if (work.settings.method == BeamMethod::kAdaptive) {
        planLattice(scene, plan, work);
    }
    if (work.settings.method == BeamMethod::kClipped ||
        work.settings.method == BeamMethod::kAdaptive) {
        planShadowPyramid(cache, plan, work);
    }
    plan.beams = std::move(work);
}

// Of all that this frame draws, what has another shape than when it was last drawn.
void planDeform(const Scene& scene, const FrameCache& cache, FramePlan& plan) {
    std::vector<bool> isDrawn(scene.deformers.size(), false);
    const auto addAll = [&](const std::vector<int>& draws) {
        for (const int draw : draws) {
            const int deformer = deformerOf(scene, plan.draws[std::size_t(draw)]);
            if (deformer >= 0) {
                isDrawn[std::size_t(deformer)] = true;
            }
        }
    };
    for (const ShadowMapWork& work : plan.shadowMapWork) {
        addAll(work.casters);
    }
    if (plan.forward) {
        addAll(plan.forward->opaque);
        addAll(plan.forward->blended);
    }
    for (std::size_t i = 0; plan.sunShadow && i < plan.sunShadow->cascades.size(); ++i) {
        if (!plan.sunShadow->cascades[i].kept) {
            addAll(plan.sunShadow->cascades[i].casters);
        }
    }
    for (std::size_t i = 0; i < isDrawn.size(); ++i) {
        if (!isDrawn[i]) {
            continue;
        }
        const Deformer& deformer = scene.deformers[i];
        if (i < cache.shapes.size() && cache.shapes[i] == deformer.shape) {
            ++plan.deformersKept;
            continue;
        }
        plan.deformWork.push_back(int(i));
        const int mesh = scene.nodes[std::size_t(deformer.node)].mesh;
        for (const Primitive& primitive : scene.meshes[std::size_t(mesh)].primitives) {
            plan.verticesDeformed += std::int64_t(primitive.positions.size());
        }
    }
}

}  // namespace

bool ShadowKey::operator==(const ShadowKey& other) const {
    return frame.position == other.frame.position &&
           frame.worldFromLocal == other.frame.worldFromLocal && halfAngle == other.halfAngle &&
           rangeMetres == other.rangeMetres && side == other.side && casters == other.casters;
}

FramePlan planFrame(const Scene& scene, const Camera& camera, const FrameSettings& settings,
                    const FrameCache& cache, const LitRegions& lit) {
    FramePlan plan;
    plan.settings = settings;
    plan.camera = camera;
    plan.draws = listDraws(scene);

    const glm::dmat4 clip = clipFromWorld(camera, settings.width, settings.height);
    std::vector<bool> visible(plan.draws.size());
    for (std::size_t i = 0; i < visible.size(); ++i) {
        const glm::dmat4& place = scene.nodes[std::size_t(plan.draws[i].node)].worldFromLocal;
        visible[i] = !vanishes(place) && viewTouches(clip, plan.draws[i].worldBounds);
    }

    const auto outlines = planLamps(scene, lit, visible, plan);
    planShadowMaps(scene, cache, lit, plan);
    planForward(scene, visible, plan);
    if (settings.sky) {
        std::erase(plan.directionalLights, settings.sky->sunLamp);
        plan.sky = planSky(scene, camera, settings, plan.forward.has_value(), cache.sky);
        plan.sunShadow = planSunShadow(scene, *settings.sky, camera, settings.width,
                                       settings.height, plan.draws, visible, cache.sunShadow);
    }
    if (!scene.deformers.empty()) {
        planDeform(scene, cache, plan);
    }
    if (settings.haze.scatteringPerMetre > 0.0 && !settings.illuminance) {
        planBeams(scene, outlines, cache, plan);
    }
    if (settings.display) {
        plan.tonemap = TonemapWork{settings.ev100, settings.toneCurve, {}};
        if (settings.illuminance) {
            plan.tonemap->highestLux = settings.illuminance->highestLux;
        }
    }
    return plan;
}

void keepForNextFrame(const Scene& scene, const FramePlan& plan, FrameCache& cache) {
    if (plan.sky) {
        keepForNextFrame(*plan.sky, cache.sky);
    }
    if (plan.sunShadow) {
        keepForNextFrame(scene, plan.draws, *plan.sunShadow, cache.sunShadow);
    }
    cache.shapes.resize(scene.deformers.size(), 0);
    for (const int deformer : plan.deformWork) {
        cache.shapes[std::size_t(deformer)] = scene.deformers[std::size_t(deformer)].shape;
    }
    if (plan.shadowMaps.layers == 0) {
        return;
    }
    if (cache.shadowSide != plan.shadowMaps.side ||
        int(cache.shadowLayers.size()) != plan.shadowMaps.layers) {
        cache.shadowSide = plan.shadowMaps.side;
        cache.shadowLayers.assign(std::size_t(plan.shadowMaps.layers), std::nullopt);
        cache.pyramidLayers.assign(cache.shadowLayers.size(), false);
    }
    for (const ShadowMapWork& work : plan.shadowMapWork) {
        cache.shadowLayers[std::size_t(work.layer)] = keyOf(scene, plan, work);
        cache.pyramidLayers[std::size_t(work.layer)] = false;
    }
    for (const int layer : plan.shadowPyramidWork) {
        cache.pyramidLayers[std::size_t(layer)] = true;
    }
}

void FramePlan::keepPicture() {
    kept = true;
    deformersKept += int(deformWork.size());
    deformWork.clear();
    verticesDeformed = 0;
    shadowMapsKept += int(shadowMapWork.size());
    shadowMapWork.clear();
    shadowPyramidWork.clear();
    for (int i = 0; sunShadow && i < int(sunShadow->cascades.size()); ++i) {
        sunShadow->cascades[std::size_t(i)].kept = true;
    }
}

std::string FramePlan::describe() const {
    if (kept) {
        return "kept";
    }
    std::string line;
    const auto add = [&](const std::string& pass) { line += (line.empty() ? "" : " ") + pass; };
    if (!deformWork.empty()) {
        add("deform[" + std::to_string(deformWork.size()) + "]");
    }
    if (!shadowMapWork.empty()) {
        add("shadow_map[" + std::to_string(shadowMapWork.size()) + "]");
    }
    if (!shadowPyramidWork.empty()) {
        add("shadow_pyramid[" + std::to_string(shadowPyramidWork.size()) + "]");
    }
    if (sunShadow && sunShadow->drawn() > 0) {
        add("sun_shadow[" + std::to_string(sunShadow->drawn()) + "]");
    }
    if (forward) {
        add("forward");
    }
    if (sky) {
        const bool tables = sky->makeTables && sky->hasTables();
        add(std::string(tables ? "sky_tables " : "") + (sky->makeView ? "sky_view " : "") +
            (sky->makeAerial ? "aerial " : "") + "sky");
    }
    if (beams) {
        const bool planes = beams->settings.method == BeamMethod::kPlanes;
        add((planes ? "beams_planes[" : "beams[") + std::to_string(beams->lamps.size()) + "]");
    }
    if (tonemap) {
        add(tonemap->highestLux ? "false_color" : tonemap->ev100 ? "tonemap" : "exposure tonemap");
    }
    return line.empty() ? "nothing" : line;
}

std::vector<int> FramePlan::spotsDrawn() const {
    std::vector<int> spots;
    for (const PlannedLamp& lamp : lamps) {
        spots.push_back(lamp.spot);
    }
    return spots;
}

int FramePlan::beamTilesTotal() const {
    const int side = beams ? beams->tiles.side : gpu::kTileSide;
    return ((settings.width + side - 1) / side) * ((settings.height + side - 1) / side);
}

int FramePlan::beamTilesDrawn() const {
    if (!beams || kept) {
        return 0;
    }
    if (beams->settings.method == BeamMethod::kPlanes) {
        return beamTilesTotal();  // they go through the whole view
    }
    std::set<std::pair<int, int>> places;  // a tile may be there once for each of its lamps
    for (const gpu::BeamSquare& tile : beams->tiles.tiles) {
        places.emplace(tile.place.x, tile.place.y);
    }
    return int(places.size());
}

std::uint64_t FramePlan::beamSamples() const {
    if (!beams || kept) {
        return 0;
    }
    const auto planes = std::uint64_t(beams->settings.planes);
    if (beams->settings.method == BeamMethod::kPlanes) {
        return planes * beams->lamps.size() * std::uint64_t(settings.width) *
               std::uint64_t(settings.height);
    }
    std::uint64_t pixelLamps = 0;
    const int side = beams->tiles.side;
    for (const gpu::BeamSquare& tile : beams->tiles.tiles) {
        const int across = std::min(side, settings.width - tile.place.x * side);
        const int down = std::min(side, settings.height - tile.place.y * side);
        pixelLamps += std::uint64_t(across) * std::uint64_t(down) * std::uint64_t(tile.place.w);
    }
    return planes * pixelLamps;
}

}  // namespace ribalta
