// Environment: light from all around a scene, as EXT_lights_image_based gives it.
#pragma once

#include <array>
#include <string>

#include <glm/glm.hpp>

namespace ribalta {

struct Environment {
    std::string name;
    /// By channel: on a surface with the unit normal n, in world axes, fall (n, 1) M (n, 1) lux.
    /// See shaders/lib/environment.glsl.
    std::array<glm::dmat4, 3> lux{glm::dmat4(0.0), glm::dmat4(0.0), glm::dmat4(0.0)};
};

/// Lux by channel on a surface with that unit normal.
glm::dvec3 irradiance(const Environment& environment, const glm::dvec3& normal);

/// Coefficients of irradiance, in lux: of the real spherical harmonics without signs of their own
/// (Ramamoorthi and Hanrahan 2001), in the order 00, 1-1, 10, 11, 2-2, 2-1, 20, 21, 22, the first
/// three of which are those of y, z and x.
using IrradianceCoefficients = std::array<glm::dvec3, 9>;

/// The environment of the coefficients, turned by a rotation: what came from d comes from
/// rotation * d.
std::array<glm::dmat4, 3> irradianceForm(const IrradianceCoefficients& coefficients,
                                         const glm::dmat3& rotation);

/// The same seen in other axes: `worldFromOther` is a rotation.
glm::dmat4 inOtherAxes(const glm::dmat4& form, const glm::dmat3& worldFromOther);

}  // namespace ribalta
