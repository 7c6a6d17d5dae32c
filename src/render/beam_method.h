// BeamMethod: the ways of summing the light in the haze, by name.
#pragma once

#include <span>

#include "base/names.h"

namespace ribalta {

enum class BeamMethod {
    kPlanes,    ///< the thesis's view-aligned planes over the camera's depth range
    kMarch,     ///< even steps along the part of each pixel's ray inside the beam, lamp by lamp
    kClipped,   ///< sheets there, even in the lamp's projection, all lamps of a pixel at once
    kAdaptive,  ///< `clipped` at every fourth pixel each way, and where the light bends in between
};

/// As on the command line, in looks, reports and plans; the baseline first.
std::span<const Named<BeamMethod>> beamMethods();

inline std::string_view name(BeamMethod method) {
    return nameIn(beamMethods(), method);
}

}  // namespace ribalta
