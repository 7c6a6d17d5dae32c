// RayCaster: what a ray meets first, and whether two points see each other. The only place that
// knows Embree.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "reference/material_textures.h"
#include "reference/placed_surface.h"

namespace ribalta {

/// Where a ray meets a triangle.
struct SurfaceHit {
    std::uint32_t surface = 0;   ///< into the surfaces the caster was made of
    std::uint32_t triangle = 0;  ///< of that surface
    double distance = 0.0;       ///< metres along the ray
    glm::dvec3 weights{0.0};     ///< of the triangle's corners; they add up to 1
    bool front = true;           ///< whether its front face is seen
};

/// What a ray sees.
struct Sight {
    std::optional<SurfaceHit> opaque;  ///< the nearest that is not blended
    std::vector<SurfaceHit> blended;   ///< all before it, in the order they are drawn over it
};

/// Embree finds candidates in single precision, around an origin given to it; each is then met anew
/// in double precision, so that a surface does not shade itself and distances are exact.
class RayCaster {
  public:
    /// Keeps references to both. `origin`, a point in the world near which the scene is looked at,
    /// is where single precision is at its best. Throws Error(kJobFailed) where memory runs out.
    RayCaster(std::span<const PlacedSurface> surfaces, const MaterialTextures& textures,
              const glm::dvec3& origin);
    ~RayCaster();
    RayCaster(const RayCaster&) = delete;
    RayCaster& operator=(const RayCaster&) = delete;

    /// Looks along a ray (unit direction) from `first` to `last` metres. Back faces of surfaces
    /// that are not double-sided are not seen, nor are masked surfaces' holes.
    void look(const glm::dvec3& from, const glm::dvec3& direction, double first, double last,
              Sight& sight) const;

    /// Whether something that casts shadows stands between two points. What touches `from` to
    /// within a billionth of the distances at hand does not.
    bool isBlocked(const glm::dvec3& from, const glm::dvec3& to) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace ribalta
