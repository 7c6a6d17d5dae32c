#include "render/gpu_frame.h"

#include <algorithm>
#include <cmath>

#include <shared/lamp.h>
#include <shared/slots.h>
#include <shared/surface.h>
#include <shared/view.h>

#include "render/lamp_reach.h"

namespace ribalta {
namespace {

// Nothing nearer to a lamp than this casts a shadow: its own housing may stand there.
constexpr double kShadowNearMetres = 0.05;

// 1 / tan of the shadow map's half angle: two texels wider than the beam, for the filter.
double shadowScale(const SpotLight& lamp, int side) {
    return (1.0 - 4.0 / side) / std::tan(drawnConeAngle(lamp));
}

double inverseRange(double rangeMetres) {
    return std::isfinite(rangeMetres) ? 1.0 / rangeMetres : 0.0;
}

gpu::View describeView(const FramePlan& plan) {
    const FrameSettings& settings = plan.settings;
    const Camera& camera = plan.camera;
    const glm::dmat4 view = viewFromWorld(camera);
    const glm::dvec2 half = viewHalfExtent(camera, settings.width, settings.height);
    const double n = camera.nearMetres;
    const double f = camera.farMetres;

    gpu::View result{};
    result.clipFromView =
        clipFromWorld(camera, settings.width, settings.height) * worldFromView(camera);
    result.halfExtent = glm::vec4(half.x, half.y, camera.isOrthographic() ? 1.0 : 0.0, 0.0);
    const double farShown = std::isfinite(f) ? f : 1e30;
    if (camera.isOrthographic()) {
        result.depthTerms = glm::vec4(f, n - f, n, farShown);
    } else if (std::isfinite(f)) {
        result.depthTerms = glm::vec4(n * f / (f - n), -n / (f - n), n, farShown);
    } else {
        result.depthTerms = glm::vec4(n, 0.0, n, farShown);
    }
    result.picture =
        glm::vec4(settings.width, settings.height, 1.0 / settings.width, 1.0 / settings.height);
    const Haze& haze = settings.haze;
    result.haze =
        glm::vec4(haze.scatteringPerMetre, haze.extinctionPerMetre(), haze.phase.g, haze.phase.k);
    result.upAmbient = glm::vec4(glm::dmat3(view) * glm::dvec3(0.0, 1.0, 0.0), settings.ambientLux);
    result.lampCounts =
        glm::ivec4(plan.lamps.size(), plan.pointLights.size(), plan.directionalLights.size(), 0);
    return result;
}

gpu::SpotLamp describeSpot(const SpotLight& lamp, int shadowLayer, const glm::dmat4& worldFromView,
                           int shadowSide, const GpuScene& gpuScene) {
    const double outer = drawnConeAngle(lamp);
    const double inner = std::clamp(lamp.innerConeAngle, 0.0, outer);
    const double rotation = lamp.lightMap ? lamp.lightMap->rotationRadians : 0.0;
    gpu::SpotLamp result{};
    result.lampFromView = lampFromWorld(lamp) * worldFromView;
    result.candela =
        glm::vec4(lamp.color * float(lamp.intensityCandela), float(inverseRange(lamp.rangeMetres)));
    result.cone = glm::vec4(std::cos(inner), std::cos(outer), std::cos(outer) * std::cos(outer),
                            std::sin(outer) * std::sin(outer));
    result.projection = glm::vec4(1.0 / std::tan(outer), std::cos(rotation), std::sin(rotation),
                                  lamp.beamShape == BeamShape::kPyramid ? 1.0 : 0.0);
    if (shadowLayer >= 0) {
        const double scale = shadowScale(lamp, shadowSide);
        result.shadow = glm::vec4(scale, kShadowNearMetres, 2.0 / (scale * shadowSide), shadowSide);
    }
    const int lightMap = gpuScene.lightMapLayer(lamp);
    result.layers =
        glm::ivec4(shadowLayer, lightMap, lightMap < 0 ? 0 : gpuScene.lightMaps().size().width, 0);
    return result;
}

gpu::SpotCone describeCone(const SpotLight& lamp, const glm::dmat4& viewFromWorld) {
    const double tangent = std::tan(drawnConeAngle(lamp));
    // A square's corners lie sqrt(2) farther out than its sides.
    const double widest = lamp.beamShape == BeamShape::kPyramid ? 2.0 : 1.0;
    return {glm::vec4(glm::dvec3(viewFromWorld * glm::dvec4(lamp.frame.position, 1.0)),
                      1.0 / (1.0 + widest * tangent * tangent)),
            glm::vec4(glm::dmat3(viewFromWorld) * lamp.frame.forward(), 0.0)};
}

template <typename Value>
void uploadList(Buffer& buffer, const char* label, int slot, const std::vector<Value>& values) {
    buffer.write(label, bytesOf(values));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, GLuint(slot), buffer.name());
}

gpu::SurfaceInstance describeInstance(const Scene& scene, const DrawItem& item,
                                      const glm::dmat4& viewFromWorld) {
    const glm::dmat4 viewFromLocal =
        viewFromWorld * scene.nodes[std::size_t(item.node)].worldFromLocal;
    gpu::SurfaceInstance result{};
    result.viewFromLocal = viewFromLocal;
    if (primitiveOf(scene, item).normals.empty()) {
        return result;
    }
    // The adjugate turns normals as the inverse transpose does, and stands a flattened node.
    const glm::dmat3 linear(viewFromLocal);
    const glm::dmat3 normals(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                             glm::cross(linear[0], linear[1]));
    const double size =
        std::max({glm::length(normals[0]), glm::length(normals[1]), glm::length(normals[2])});
    const double scale = size > 0.0 ? (item.mirrored ? -1.0 : 1.0) / size : 0.0;
    for (int column = 0; column < 3; ++column) {
        result.viewFromNormal[column] = glm::vec4(scale * normals[column], 0.0);
    }
    return result;
}

std::vector<gpu::SurfaceInstance> describeSurfaces(const Scene& scene, const FramePlan& plan,
                                                   const glm::dmat4& viewFromWorld) {
    std::vector<gpu::SurfaceInstance> instances;
    if (plan.forward) {
        instances.reserve(plan.forward->opaque.size() + plan.forward->blended.size());
        for (const auto* list : {&plan.forward->opaque, &plan.forward->blended}) {
            for (const int draw : *list) {
                instances.push_back(
                    describeInstance(scene, plan.draws[std::size_t(draw)], viewFromWorld));
            }
        }
    }
    return instances;
}

}  // namespace

glm::dmat4 shadowClipFromWorld(const SpotLight& lamp, int side) {
    const double scale = shadowScale(lamp, side);
    glm::dmat4 clipFromLamp(0.0);
    clipFromLamp[0][0] = scale;
    clipFromLamp[1][1] = scale;
    clipFromLamp[3][2] = kShadowNearMetres;
    clipFromLamp[2][3] = 1.0;
    return clipFromLamp * lampFromWorld(lamp);
}

void GpuFrame::upload(const Scene& scene, const FramePlan& plan, const GpuScene& gpuScene,
                      const SkyLighting* daylight) {
    const glm::dmat4 fromView = worldFromView(plan.camera);
    const glm::dmat4 fromWorld = viewFromWorld(plan.camera);

    std::vector<gpu::View> view = {describeView(plan)};
    view.front().lampCounts.z += daylight != nullptr ? 1 : 0;
    if (scene.environment) {
        view.front().lampCounts.w = 1;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            view.front().environment[channel] =
                inOtherAxes(scene.environment->lux[channel], glm::dmat3(fromView));
        }
    }
    view_.write("view", bytesOf(view));
    glBindBufferBase(GL_UNIFORM_BUFFER, gpu::kViewSlot, view_.name());

    std::vector<gpu::SpotLamp> spots;
    std::vector<gpu::SpotCone> cones;
    for (const PlannedLamp& lamp : plan.lamps) {
        const SpotLight& spot = scene.spotLights[std::size_t(lamp.spot)];
        spots.push_back(
            describeSpot(spot, lamp.shadowLayer, fromView, plan.shadowMaps.side, gpuScene));
        spots.back().towardsEye =
            glm::vec4(plan.sky ? transmittanceBetween(plan.sky->drawing, plan.camera.frame.position,
                                                      spot.frame.position)
                               : glm::dvec3(1.0),
                      1.0);
        cones.push_back(describeCone(spot, fromWorld));
    }
    uploadList(spotLamps_, "spot lamps", gpu::kLampsSlot, spots);
    uploadList(spotCones_, "spot cones", gpu::kSpotConesSlot, cones);

    std::vector<gpu::PointLamp> points;
    for (const int index : plan.pointLights) {
        const PointLight& lamp = scene.pointLights[std::size_t(index)];
        const glm::dvec3 place(fromWorld * glm::dvec4(lamp.position, 1.0));
        points.push_back({glm::vec4(place, inverseRange(lamp.rangeMetres)),
                          glm::vec4(lamp.color * float(lamp.intensityCandela), 0.0F)});
    }
    uploadList(pointLamps_, "point lamps", gpu::kPointLampsSlot, points);

    std::vector<gpu::DirectionalLamp> directional;
    for (const int index : plan.directionalLights) {
        const DirectionalLight& lamp = scene.directionalLights[std::size_t(index)];
        directional.push_back({glm::vec4(glm::dmat3(fromWorld) * -lamp.direction, 0.0),
                               glm::vec4(lamp.color * float(lamp.illuminanceLux), 0.0F)});
    }
    if (daylight != nullptr) {
        directional.push_back({glm::vec4(glm::dmat3(fromWorld) * daylight->towardsSun, 0.0),
                               glm::vec4(daylight->sunLux, 0.0)});
    }
    uploadList(directionalLamps_, "directional lamps", gpu::kDirectionalLampsSlot, directional);

    surfaces_.write("surfaces", bytesOf(describeSurfaces(scene, plan, fromWorld)));
}

}  // namespace ribalta
