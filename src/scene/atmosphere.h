// Atmosphere: a planet's ground, its air and the sun above it, as plain data. No light is computed
// here. The air thins out exponentially with height and ends at a top; it neither bends light nor
// holds ozone.
#pragma once

#include <optional>
#include <string>

#include <glm/glm.hpp>

namespace ribalta {

/// Colours are per linear sRGB channel; coefficients are those at the ground. The values it has at
/// first are Earth's for light of 680, 550 and 440 nm (Bruneton & Neyret 2008).
struct Atmosphere {
    double groundRadiusMetres = 6.36e6;
    double topMetres = 60e3;  ///< height above the ground at which the air ends

    glm::dvec3 rayleighScatteringPerMetre{5.8e-6, 13.5e-6, 33.1e-6};
    double rayleighScaleHeightMetres = 8000.0;

    glm::dvec3 mieScatteringPerMetre{4.0e-6};
    glm::dvec3 mieExtinctionPerMetre{4.44e-6};  ///< scattering and absorption
    double mieScaleHeightMetres = 1200.0;
    double mieG = 0.8;  ///< asymmetry of Cornette and Shanks' phase function, -1 < g < 1

    glm::dvec3 groundAlbedo{0.1};             ///< 0..1, diffuse
    glm::dvec3 sunIlluminanceLux{128'000.0};  ///< at the top, on a plane that faces the sun
    double sunAngularRadius = 0.004653;       ///< radians

    bool operator==(const Atmosphere&) const = default;
};

/// What makes no sense about an atmosphere.
struct AtmosphereFault {
    std::string name;     ///< of the value: rayleighScattering/g, top, mieG ...
    std::string message;  ///< what it is, what was expected and how to mend it
};

/// The first value that makes no sense; none where all do: nothing finite, radii and heights not
/// above 0 or out of the range that single precision can draw (a ground of 1 km to 1e9 m, a top of
/// 1 m to 10 radii, scale heights of 1 m to 1e6 m), negative coefficients, more scattering than
/// extinction, |g| > 0.9999, an albedo beyond 0..1, a sun of negative light or wider than 90
/// degrees.
std::optional<AtmosphereFault> faultOf(const Atmosphere& air);

/// `air` as it is. Throws Error(kUsage) that says what faultOf() finds.
Atmosphere checked(const Atmosphere& air);

/// `air` without Mie's part, as clean air has none.
Atmosphere withoutMie(const Atmosphere& air);

}  // namespace ribalta
