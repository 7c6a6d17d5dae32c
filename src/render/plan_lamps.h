// Which lamps a frame needs: those that light something in view or show a beam there. The others
// are left out, and why is counted.
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "render/lit_region.h"
#include "scene/camera.h"
#include "scene/scene.h"

namespace ribalta {

struct DrawItem;
struct FramePlan;

/// Lamps of all kinds that a frame leaves out, by the first reason that holds.
struct SkippedLamps {
    int dark = 0;  ///< no intensity, black, range 0, or a light map that lets nothing through
    int behindCamera = 0;  ///< the whole cone
    int behindScene = 0;   ///< hidden by a wall or a floor, or beyond the camera's far plane
    int outOfRange = 0;    ///< in view if only they shone farther
    int outsideView = 0;   ///< light nothing in view, and no beam crosses it

    int total() const { return dark + behindCamera + behindScene + outOfRange + outsideView; }
};

/// Puts the lamps that the frame needs into the plan, whose settings, camera and draws are there
/// already; `visible` tells of each draw whether it may be in view. Returns the outlines in the
/// picture of the spots' beams, in the order of FramePlan::lamps; empty ones in clear air.
std::vector<std::vector<glm::dvec2>> planLamps(const Scene& scene, const LitRegions& lit,
                                               const std::vector<bool>& visible, FramePlan& plan);

}  // namespace ribalta
