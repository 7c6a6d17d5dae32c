// SunShadowWork: the boxes of the scene, near ones fine and far ones coarse, for each of which a
// shadow map of the sun is drawn. As data, made on the CPU without OpenGL.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "render/draw_list.h"
#include "render/sky_settings.h"
#include "scene/camera.h"
#include "scene/scene.h"

namespace ribalta {

/// A box that the view needs shadows in. The sun's frame is the world turned so that +Z points to
/// the sun.
struct SunCascade {
    glm::dvec3 middle{0.0};         ///< of the face that looks away from the sun, in its frame
    double halfSide = 0.0;          ///< metres to its sides; it is 2 * halfSide long, for receivers
    double topMetres = 0.0;         ///< from `middle` to the end of the casters, towards the sun
    std::vector<int> casters;       ///< into FramePlan::draws
    bool kept = false;              ///< as it was drawn for an earlier frame
    glm::dmat4 clipFromWorld{1.0};  ///< reversed depth: 1 at the casters' end, 0 at `middle`
};

/// Everything a map's content depends on.
struct SunMapKey {
    glm::dmat4 clipFromWorld{1.0};
    std::vector<DrawPlace> casters;

    bool operator==(const SunMapKey&) const = default;
};

/// What earlier frames left behind that this one may use.
struct SunShadowCache {
    int side = 0;  ///< texels of the maps that are there
    std::vector<std::optional<SunMapKey>> layers;
};

struct SunShadowWork {
    int side = 0;    ///< texels of a map
    int layers = 0;  ///< maps that there is room for; cascade i lives in layer i
    glm::dmat3 sunFromWorld{1.0};
    std::vector<SunCascade> cascades;  ///< near to far
    int castersCulled = 0;             ///< what casts shadows, but not into a cascade's box

    int drawn() const;  ///< maps to draw
    double texelMetres(const SunCascade& cascade) const { return 2.0 * cascade.halfSide / side; }
};

inline constexpr int kMostSunCascades = 6;
/// So far from a map's edge no look-up is asked for: the filter needs what lies there.
inline constexpr int kSunMapMargin = 12;  // texels

/// Whether any of the sun's disc is seen where the scene's origin stands.
bool sunIsUp(const SkyDrawing& sky);

/// The shadows that the sun throws on what is visible; none: it is down, or nothing that casts
/// shadows stands between it and what is seen.
std::optional<SunShadowWork> planSunShadow(const Scene& scene, const SkyDrawing& sky,
                                           const Camera& camera, int width, int height,
                                           const std::vector<DrawItem>& draws,
                                           const std::vector<bool>& visible,
                                           const SunShadowCache& cache);
void keepForNextFrame(const Scene& scene, const std::vector<DrawItem>& draws,
                      const SunShadowWork& work, SunShadowCache& cache);

}  // namespace ribalta
