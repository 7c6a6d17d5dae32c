#include "render/evaluate_baseline_sky.h"

#include <string>

#include <shared/slots.h>

#include "gl/buffer.h"
#include "render/describe_atmosphere.h"
#include "render/evaluate_sky.h"
#include "render/passes/sky_precomputed.h"

namespace ribalta {

std::vector<SkyLight> evaluatePrecomputedSky(const PrecomputedSky& sky,
                                             std::span<const SkyRay> rays) {
    sky.bind();
    return evaluateRays(sky.atmosphere(), rays, "passes/sky_precomputed_points.comp",
                        sky.defines());
}

std::vector<SkyLight> evaluateChapmanSky(const Atmosphere& air, const ChapmanSky& sky,
                                         std::span<const SkyRay> rays) {
    const std::vector<gpu::Atmosphere> described = {describeAtmosphere(air)};
    const Buffer block("atmosphere", spreadForUniforms(described));
    block.bindUniform(gpu::kAtmosphereSlot, 0);
    std::vector<std::string> defines = {"SKY_SEGMENTS " + std::to_string(sky.segments)};
    if (sky.better) {
        defines.emplace_back("SKY_CHAPMAN_BETTER");
    }
    return evaluateRays(air, rays, "passes/sky_chapman_points.comp", defines);
}

}  // namespace ribalta
