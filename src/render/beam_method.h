// BeamMethod: the ways of summing the light in the haze, by name.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace ribalta {

enum class BeamMethod {
    kClipped,  ///< sheets confined to the part of each pixel's ray inside the beam
    kPlanes,   ///< the thesis's view-aligned planes over the camera's depth range
};

/// As on the command line, in reports and in plans.
std::string_view name(BeamMethod method);

/// None: no method has this name.
std::optional<BeamMethod> beamMethodNamed(std::string_view name);

/// All there are, the baseline first.
std::span<const BeamMethod> allBeamMethods();

}  // namespace ribalta
