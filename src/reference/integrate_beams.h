// The exact answer for light scattered once out of spot beams along a ray: double precision,
// adaptive. Knows neither pictures nor geometry; what blocks light is asked of the caller.
#pragma once

#include <memory>
#include <span>

#include <glm/glm.hpp>

#include "image/image.h"
#include "reference/beam_visibility.h"
#include "scene/haze.h"
#include "scene/light.h"

namespace ribalta {

/// What the eye looks along, in the world.
struct BeamRay {
    glm::dvec3 origin{0.0};                ///< metres
    glm::dvec3 direction{0.0, 0.0, -1.0};  ///< unit
    double first = 0.0;                    ///< metres from the origin, >= 0: the near plane
    double last = 0.0;                     ///< metres from the origin: the surface, or infinity
    /// Width of what the pixel sees: so many metres at the origin, and for each metre along the
    /// ray so many more. Light maps are filtered over it; without width they are read at a point.
    double width = 0.0;
    double widening = 0.0;
};

/// What reaches the eye along a ray.
struct BeamLight {
    glm::dvec3 value{0.0};  ///< cd/m2 per linear sRGB channel
    double error = 0.0;     ///< estimate for the worst channel, cd/m2; on the safe side
    int evaluations = 0;    ///< of the scattering integrand
};

/// Sums the beams of a set of lamps in even haze. Cone angles are kept within kMinConeAngle and
/// kMaxConeAngle, beams begin at the lens plane (shaders/lib/spot_light.glsl).
///
/// The integrand is a smooth function times the light map. The ray is cut where visibility changes
/// and where the cone's falloff begins; between the cuts the smooth function is replaced by
/// polynomials, as many as the accuracy asks for, and their products with the light map are
/// integrated cell by cell of its bilinear filter, where they are polynomials too.
class BeamIntegrator {
  public:
    /// Copies the lamps and decodes the light maps they use out of `images` (Scene::images; a
    /// lamp's LightMap::image must be in range). Without `visibility` nothing blocks light.
    /// `relativeError` is asked of each lamp's part, 1e-12..0.1.
    BeamIntegrator(std::span<const SpotLight> lamps, std::span<const Image> images,
                   const Haze& haze, std::unique_ptr<BeamVisibility> visibility,
                   double relativeError = 1e-6);
    ~BeamIntegrator();
    BeamIntegrator(BeamIntegrator&&) noexcept;
    BeamIntegrator& operator=(BeamIntegrator&&) noexcept;

    /// All lamps together. May be called from several threads at once.
    BeamLight along(const BeamRay& ray) const;
    /// Those that give light; BeamLamp::index is into the lamps it was made of.
    std::span<const BeamLamp> lamps() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace ribalta
