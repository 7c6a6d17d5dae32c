#include "render/plan_lamps.h"

#include <algorithm>
#include <limits>

#include "render/frame_plan.h"
#include "render/lamp_reach.h"
#include "render/occluders.h"

namespace ribalta {
namespace {

using Outline = std::vector<glm::dvec2>;

constexpr double kEndless = std::numeric_limits<double>::infinity();

// What the tests of one frame's lamps share.
struct View {
    const FramePlan& plan;
    const std::vector<bool>& visible;
    std::vector<Occluder> occluders;
    bool haze = false;

    Outline outlineOf(const SpotLight& lamp) const {
        return beamOutline(lamp, plan.camera, plan.settings.width, plan.settings.height);
    }
    bool showsBeam(const Outline& outline) const {
        return haze &&
               !makeBeamTiles({outline}, plan.settings.width, plan.settings.height).tiles.empty();
    }
    bool isLit(const SpotLight& lamp) const {
        for (std::size_t i = 0; i < visible.size(); ++i) {
            if (visible[i] && beamTouches(lamp, plan.draws[i].worldBounds)) {
                return true;
            }
        }
        return false;
    }
    bool isHidden(const SpotLight& lamp, const Outline& outline) const {
        return isBeyondFarPlane(lamp, plan.camera) ||
               std::any_of(occluders.begin(), occluders.end(), [&](const Occluder& occluder) {
                   return hides(occluder, lamp, outline, plan.settings.width, plan.settings.height);
               });
    }
};

// Null where the frame needs the lamp, else the reason why it does not. `lamp` is its lit part.
int SkippedLamps::*whyNot(const View& view, const SpotLight& lamp, const Outline& outline) {
    if (isDark(lamp)) {
        return &SkippedLamps::dark;
    }
    if (outline.empty()) {
        return &SkippedLamps::behindCamera;
    }
    if (view.isLit(lamp) || view.showsBeam(outline)) {
        return view.isHidden(lamp, outline) ? &SkippedLamps::behindScene : nullptr;
    }
    SpotLight endless = lamp;
    endless.rangeMetres = kEndless;
    return view.isLit(endless) || view.showsBeam(view.outlineOf(endless))
               ? &SkippedLamps::outOfRange
               : &SkippedLamps::outsideView;
}

double distanceTo(const Bounds& bounds, const glm::dvec3& point) {
    return glm::length(
        glm::max(glm::abs(bounds.centre() - point) - bounds.halfSize(), glm::dvec3(0.0)));
}

int SkippedLamps::*whyNot(const View& view, const PointLight& lamp) {
    if (!lamp.shown || !(lamp.intensityCandela > 0.0) || lamp.color == glm::vec3(0.0F)) {
        return &SkippedLamps::dark;
    }
    double nearest = kEndless;
    for (std::size_t i = 0; i < view.visible.size(); ++i) {
        if (view.visible[i]) {
            nearest = std::min(nearest, distanceTo(view.plan.draws[i].worldBounds, lamp.position));
        }
    }
    if (nearest == kEndless) {
        return &SkippedLamps::outsideView;
    }
    return nearest <= lamp.rangeMetres ? nullptr : &SkippedLamps::outOfRange;
}

int SkippedLamps::*whyNot(const View& view, const DirectionalLight& lamp) {
    if (!lamp.shown || !(lamp.illuminanceLux > 0.0) || lamp.color == glm::vec3(0.0F)) {
        return &SkippedLamps::dark;
    }
    const bool anything =
        std::find(view.visible.begin(), view.visible.end(), true) != view.visible.end();
    return anything ? nullptr : &SkippedLamps::outsideView;
}

template <typename Lamp>
void planOthers(const View& view, const std::vector<Lamp>& lamps, std::vector<int>& planned,
                SkippedLamps& skipped) {
    for (std::size_t i = 0; i < lamps.size(); ++i) {
        if (const auto reason = whyNot(view, lamps[i])) {
            ++(skipped.*reason);
        } else {
            planned.push_back(int(i));
        }
    }
}

}  // namespace

std::vector<std::vector<glm::dvec2>> planLamps(const Scene& scene, const LitRegions& lit,
                                               const std::vector<bool>& visible, FramePlan& plan) {
    View view{plan, visible, {}, plan.settings.haze.scatteringPerMetre > 0.0};
    if (!scene.spotLights.empty()) {
        view.occluders = listOccluders(scene, plan.draws, visible, plan.camera, plan.settings.width,
                                       plan.settings.height);
    }
    std::vector<Outline> outlines;
    for (std::size_t s = 0; s < scene.spotLights.size(); ++s) {
        const SpotLight lamp = litPart(scene.spotLights[s], lit);
        Outline outline = isDark(lamp) ? Outline() : view.outlineOf(lamp);
        if (const auto reason = whyNot(view, lamp, outline)) {
            ++(plan.skipped.*reason);
            continue;
        }
        plan.lamps.push_back({int(s), -1});
        outlines.push_back(view.haze ? std::move(outline) : Outline());
    }
    planOthers(view, scene.pointLights, plan.pointLights, plan.skipped);
    planOthers(view, scene.directionalLights, plan.directionalLights, plan.skipped);
    plan.lampsSkipped = plan.skipped.total();
    return outlines;
}

}  // namespace ribalta
