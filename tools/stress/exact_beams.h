// ExactBeams: a set-up's beams along a ray in double precision, written a second time from the
// physics: it shares no formula with shaders/lib, so that a fault there cannot hide. And how rough
// the integrand is, which says how far off a sum of n samples may be.
#pragma once

#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "reference/interval.h"
#include "set_up.h"

namespace ribalta::stress {

struct Ray {
    glm::dvec3 origin{0.0};                ///< metres, world
    glm::dvec3 direction{0.0, 0.0, -1.0};  ///< unit
    double first = 0.0;                    ///< metres: where the beams begin, the near plane
    double last = 0.0;                     ///< metres: where they end; finite
};

/// How the question is changed to see how much the answer depends on it.
struct Change {
    double cosOuter = 0.0;  ///< what the cosines of points are higher, and the cones wider
    /// Texels by which shadows are grown (shrunk where negative); none: exact shadows.
    double shadowTexels = 0.0;
    /// Whether the stretch ends where the depth, not the distance, is the lamp's range.
    bool rangeByDepth = false;
};

/// What bounds the error of the mean of samples along the ray, summed over lamps (cd/m2). f is the
/// integrand over a variable that runs over 0..1 of the sampled stretch.
struct Roughness {
    double variation = 0.0;       ///< of f, jumps counted; Koksma: error <= variation * discrepancy
    double slopeVariation = 0.0;  ///< of f'; Peano: error <= it / 8 n^2 for n midpoints; inf: jumps
    double lightMapChange = 0.0;  ///< what filtering the light maps over the samples may change
};

class ExactBeams {
  public:
    /// `shadowSide`: texels of the drawn shadow maps, 0 where there are none.
    ExactBeams(const SetUp& setUp, int shadowSide);
    ~ExactBeams();
    ExactBeams(const ExactBeams&) = delete;
    ExactBeams& operator=(const ExactBeams&) = delete;

    /// Radiance in cd/m2 to about 1e-6 of itself.
    glm::dvec3 along(const Ray& ray, const Change& change = {}) const;

    /// For at least `samples` over the stretch of the ray inside each beam, even in the lamp's
    /// projection or, with `evenMetres`, along the ray. `pixelSlope` is the width of a pixel at
    /// unit distance from the eye, or in metres where `parallel` (orthographic).
    Roughness inBeams(const Ray& ray, int samples, bool evenMetres, double pixelSlope,
                      bool parallel) const;
    /// For samples even along the whole ray.
    Roughness alongRay(const Ray& ray) const;

  private:
    struct Lamp;
    struct Stretch;
    std::optional<Stretch> enter(const Lamp& lamp, const Ray& ray, const Change& change) const;
    std::vector<Interval> lit(const Stretch& stretch, double shadowTexels) const;

    Haze haze_;
    std::vector<Lamp> lamps_;
};

}  // namespace ribalta::stress
