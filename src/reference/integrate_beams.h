// The exact answer for light scattered once out of spot beams along a ray: double precision,
// adaptive, slow. Knows neither pictures nor geometry; what blocks light is asked of the caller.
#pragma once

#include <functional>
#include <memory>
#include <span>

#include <glm/glm.hpp>

#include "image/image.h"
#include "reference/adaptive_integral.h"
#include "scene/haze.h"
#include "scene/light.h"

namespace ribalta {

/// Whether light of the lamp reaches a point in the world (metres). Asked from several threads at
/// once where along() is.
using LampVisibility = std::function<bool(const SpotLight& lamp, const glm::dvec3& point)>;

/// What the eye looks along, in the world.
struct BeamRay {
    glm::dvec3 origin{0.0};                ///< metres
    glm::dvec3 direction{0.0, 0.0, -1.0};  ///< unit
    double first = 0.0;                    ///< metres from the origin, >= 0: the near plane
    double last = 0.0;                     ///< metres from the origin: the surface, or infinity
};

/// How exact a beam is asked to be.
struct BeamAccuracy {
    IntegralAccuracy integral;  ///< of each lamp's part, in cd/m2
    /// Points of a ray at which a lamp's visibility is asked, half of them even in distance, half
    /// in the lamp's projection; changes between neighbours are then found exactly. A lit or dark
    /// stretch that falls between two neighbours is not seen.
    int visibilityProbes = 128;
};

/// Sums the beams of a set of lamps in even haze. Cone angles are kept within kMinConeAngle and
/// kMaxConeAngle, beams begin at the lens plane (shaders/lib/spot_light.glsl).
class BeamIntegrator {
  public:
    /// Copies the lamps and decodes the light maps they use out of `images` (Scene::images; a
    /// lamp's LightMap::image must be in range). An empty `isVisible` blocks no light.
    BeamIntegrator(std::span<const SpotLight> lamps, std::span<const Image> images,
                   const Haze& haze, LampVisibility isVisible, const BeamAccuracy& accuracy = {});
    ~BeamIntegrator();
    BeamIntegrator(BeamIntegrator&&) noexcept;
    BeamIntegrator& operator=(BeamIntegrator&&) noexcept;

    /// Radiance in cd/m2 per linear sRGB channel of all lamps together, with an estimate of its
    /// error. Takes some 15 evaluations for every texel of a light map that the ray crosses. May be
    /// called from several threads at once.
    Integral along(const BeamRay& ray) const;

  private:
    struct Lamp;
    struct Segment;
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace ribalta
