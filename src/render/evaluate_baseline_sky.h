// The sky's light along listed rays by the models that `auto` is held against, computed on the GPU
// by the functions that draw them. For a sun of irradiance 1.
#pragma once

#include <span>
#include <vector>

#include "render/baseline_sky_settings.h"
#include "scene/atmosphere.h"
#include "sky/sky_ray.h"

namespace ribalta {

class PrecomputedSky;

/// Needs a current context, as the tables of `sky` did.
std::vector<SkyLight> evaluatePrecomputedSky(const PrecomputedSky& sky,
                                             std::span<const SkyRay> rays);

/// The haze (Mie) of `air` is left out. Needs a current context.
std::vector<SkyLight> evaluateChapmanSky(const Atmosphere& air, const ChapmanSky& sky,
                                         std::span<const SkyRay> rays);

}  // namespace ribalta
