// Haze: the air between the lamps and the camera, the same everywhere.
#pragma once

#include <span>

#include "base/names.h"

namespace ribalta {

/// How haze turns light. cosAngle = 1 is straight on.
struct PhaseFunction {
    /// Numbered as in shaders/lib/phase_function.glsl.
    enum class Kind { kGibbons, kIsotropic, kHenyeyGreenstein, kCornetteShanks, kRayleigh };

    Kind kind = Kind::kGibbons;
    double g = 0.0;  ///< mean cosine, -1 < g < 1; Henyey-Greenstein and Cornette-Shanks only
    /// Gibbons' factor K in K (1 + 9 cos^16(alpha / 2)); 1 / (8 pi) makes it integrate to one over
    /// the sphere. The thesis uses it as a free constant.
    double k = 0.0397887357729738;

    bool hasG() const { return kind == Kind::kHenyeyGreenstein || kind == Kind::kCornetteShanks; }
    bool operator==(const PhaseFunction&) const = default;
};

/// As on the command line and in looks; the default first.
std::span<const Named<PhaseFunction::Kind>> phaseFunctions();

inline std::string_view name(PhaseFunction::Kind kind) {
    return nameIn(phaseFunctions(), kind);
}

struct Haze {
    double scatteringPerMetre = 0.02;
    double absorptionPerMetre = 0.0;
    PhaseFunction phase;

    double extinctionPerMetre() const { return scatteringPerMetre + absorptionPerMetre; }
    bool operator==(const Haze&) const = default;
};

}  // namespace ribalta
