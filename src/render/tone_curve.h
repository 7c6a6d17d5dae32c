// ToneCurve: how exposed light becomes what a screen can show, by name.
#pragma once

#include <span>

#include "base/names.h"

namespace ribalta {

/// Numbered as in shaders/lib/tonemap.glsl.
enum class ToneCurve { kNeutral, kAgx, kAces, kLinear };

/// As on the command line and in looks; the default first.
std::span<const Named<ToneCurve>> toneCurves();

inline std::string_view name(ToneCurve curve) {
    return nameIn(toneCurves(), curve);
}

}  // namespace ribalta
