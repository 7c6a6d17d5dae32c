// The sky's light along listed rays, computed on the GPU by the functions that draw the sky.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <shared/sky.h>

#include "gl/program.h"
#include "sky/sky_ray.h"
#include "sky/sky_tables.h"

namespace ribalta {

/// Runs a compute shader over rays, in one dispatch: it takes them at kSkyRaysSlot and writes a
/// light each at kSkyLightsSlot; what else it reads must be bound.
std::vector<gpu::SkyRayLight> runSkyRays(const Program& program,
                                         const std::vector<gpu::SkyRayStart>& starts);

/// Runs a model's program over rays. Its compute shader takes shared/sky.h's SkyRayStart at
/// kSkyRaysSlot and writes a SkyRayLight each at kSkyLightsSlot; what else it reads must be bound.
/// Rays are brought into the air in double precision first. Needs a current context.
std::vector<SkyLight> evaluateRays(const Atmosphere& air, std::span<const SkyRay> rays,
                                   const std::string& shader,
                                   const std::vector<std::string>& defines);

/// By the renderer's own model, for a sun of irradiance 1.
std::vector<SkyLight> evaluateSky(const Atmosphere& air, const SkyOrders& orders,
                                  std::span<const SkyRay> rays);

}  // namespace ribalta
