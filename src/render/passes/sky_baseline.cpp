#include "render/passes/sky_baseline.h"

#include <shared/slots.h>

#include "gl/program.h"
#include "render/describe_atmosphere.h"
#include "render/evaluate_sky.h"

namespace ribalta {

BaselineSky::BaselineSky(const Atmosphere& air, const DrawnSky& model) : air_(air), model_(model) {
    if (const auto* settings = std::get_if<PrecomputedSkySettings>(&model)) {
        tables_.emplace(air, *settings);
        return;
    }
    const std::vector<gpu::Atmosphere> described = {describeAtmosphere(air)};
    atmosphere_.write("atmosphere", spreadForUniforms(described));
}

void BaselineSky::bind() const {
    if (tables_) {
        tables_->bind();
    } else {
        atmosphere_.bindUniform(gpu::kAtmosphereSlot, 0);
    }
}

std::vector<std::string> BaselineSky::defines() const {
    std::vector<std::string> defines = {"SKY_BASELINE"};
    if (tables_) {
        defines.emplace_back("SKY_PRECOMPUTED");
        for (const std::string& more : tables_->defines()) {
            defines.push_back(more);
        }
        return defines;
    }
    const auto& chapman = std::get<ChapmanSky>(model_);
    defines.push_back("SKY_SEGMENTS " + std::to_string(chapman.segments));
    if (chapman.better) {
        defines.emplace_back("SKY_CHAPMAN_BETTER");
    }
    return defines;
}

SkyLighting BaselineSky::lighting(const SkyDrawing& sky) const {
    const double muS = sky.towardsSun.y;
    glm::dvec3 sunlight(1.0);
    SkyIrradiance irradiance;
    // A scene above the air is lit by what comes through its limb, if anything of it is in the way.
    if (const std::optional<AirPath> path = airPath(air_, {sky.altitudeMetres, muS, muS, 1.0})) {
        bind();
        const Program program({"passes/sky_baseline_daylight.comp"}, defines());
        const gpu::SkyRayLight light =
            runSkyRays(program, {{glm::vec4(path->height, path->mu, path->muS, 1.0F),
                                  glm::vec4(path->length, 0.0, 0.0, 0.0)}})
                .front();
        sunlight = glm::dvec3(light.transmittance);
        irradiance.up = glm::dvec3(light.air);
        irradiance.towardsSun = 0.5 * irradiance.up;
        irradiance.awayFromSun = irradiance.towardsSun;
        irradiance.across = irradiance.towardsSun;
    }
    return skyLighting(sky, sunlight, irradiance);
}

}  // namespace ribalta
