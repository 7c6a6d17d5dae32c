#include "render/evaluate_sky.h"

#include <shared/slots.h>

#include "gl/buffer.h"
#include "gl/counters.h"
#include "gl/work_groups.h"
#include "render/sky_textures.h"

namespace ribalta {
namespace {

// As many rays as one dispatch of any OpenGL takes.
constexpr std::size_t kMostRays = std::size_t(65535) * gpu::kSkyRayGroup;

}  // namespace

std::vector<gpu::SkyRayLight> runSkyRays(const Program& program,
                                         const std::vector<gpu::SkyRayStart>& starts) {
    Buffer rays("sky rays", bytesOf(starts));
    std::vector<gpu::SkyRayLight> result(starts.size());
    Buffer lights("sky lights", bytesOf(result));
    glUseProgram(program.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, gpu::kSkyRaysSlot, rays.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, gpu::kSkyLightsSlot, lights.name());
    glDispatchCompute(workGroups(int(starts.size()), gpu::kSkyRayGroup), 1, 1);
    ++glCounters().drawCalls;
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    lights.read(std::as_writable_bytes(std::span(result)));
    return result;
}

std::vector<SkyLight> evaluateRays(const Atmosphere& air, std::span<const SkyRay> rays,
                                   const std::string& shader,
                                   const std::vector<std::string>& defines) {
    std::vector<SkyLight> lights(rays.size());
    std::vector<gpu::SkyRayStart> starts;
    std::vector<std::size_t> places;
    const Program program({shader}, defines);
    const auto flush = [&] {
        if (starts.empty()) {
            return;
        }
        const std::vector<gpu::SkyRayLight> found = runSkyRays(program, starts);
        for (std::size_t i = 0; i < found.size(); ++i) {
            lights[places[i]] = {glm::dvec3(found[i].transmittance), glm::dvec3(found[i].air),
                                 glm::dvec3(found[i].ground)};
        }
        starts.clear();
        places.clear();
    };
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (const std::optional<AirPath> path = airPath(air, rays[i])) {
            starts.push_back({glm::vec4(path->height, path->mu, path->muS, path->nu),
                              glm::vec4(path->length, path->ground ? 1.0 : 0.0,
                                        path->endsOnGround ? 1.0 : 0.0, 0.0)});
            places.push_back(i);
        }
        if (starts.size() == kMostRays) {
            flush();
        }
    }
    flush();
    return lights;
}

std::vector<SkyLight> evaluateSky(const Atmosphere& air, const SkyOrders& orders,
                                  std::span<const SkyRay> rays) {
    SkyTextures textures;
    textures.make(air, orders);
    textures.bind();
    gpu::SkyFrame frame{};
    frame.suns = glm::vec4(textures.tables().suns(), 0.0);
    const std::vector<gpu::SkyFrame> frames = {frame};
    const Buffer buffer("sky", bytesOf(frames));
    glBindBufferBase(GL_UNIFORM_BUFFER, gpu::kSkySlot, buffer.name());
    return evaluateRays(air, rays, "passes/sky_points.comp", textures.defines());
}

}  // namespace ribalta
