#include "render/passes/sky_precomputed.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <optional>
#include <string>

#include <shared/sky_precomputed.h>
#include <shared/slots.h>

#include "base/error.h"
#include "base/progress.h"
#include "gl/available_texture_memory.h"
#include "gl/counters.h"
#include "gl/debug_output.h"
#include "gl/program.h"
#include "gl/timer.h"
#include "gl/work_groups.h"
#include "render/describe_atmosphere.h"

namespace ribalta {
namespace {

// What one dispatch may add up: a fraction of a second on a slow machine without a GPU.
constexpr int kSamplesPerDispatch = 1 << 22;
// A texel's, in the passes over the volume; as the shaders have them.
constexpr int kStepsOfRay = 51;
constexpr int kStepsOfExactTexel = 128;
constexpr int kDirections = 512;

constexpr int kTexelsOfGroup = 8;  // each way

Texture2D makePlane(const std::string& label, const SkyPlaneSize& size) {
    Texture2D plane(label, GL_RGBA32F, {size.across, size.heights});
    plane.setSampling(GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE);
    return plane;
}

gpu::PrecomputedSky describe(const PrecomputedSkySettings& settings) {
    const SkyVolumeSize& volume = settings.scattering;
    gpu::PrecomputedSky result{};
    result.scattering = glm::vec4(volume.suns, volume.viewAngles, volume.heights, volume.sunAngles);
    result.suns = glm::vec4(settings.lowestSun, 0.0F, 0.0F, 0.0F);
    return result;
}

// Drivers grant more than there is, and the system ends the program when it is used.
void refuseWithoutMemory(const PrecomputedSkySettings& settings) {
    const std::uint64_t needed = skyTableBytes(settings).peak;
    const std::optional<std::uint64_t> available = availableTextureMemory();
    if (available && needed > *available) {
        throw Error(ErrorKind::kJobFailed, {},
                    "the sky's tables would take " + std::to_string(needed >> 20U) + " MB, and " +
                        std::to_string(*available >> 20U) +
                        " MB are free; ask for smaller ones, --table-size");
    }
}

void bindImage(int unit, GLuint texture, bool volume, GLenum access, GLenum format) {
    glBindImageTexture(GLuint(unit), texture, 0, volume ? GL_TRUE : GL_FALSE, 0, access, format);
}

}  // namespace

/// The work of the constructor, with the tables that only it needs.
class PrecomputedSky::Maker {
  public:
    explicit Maker(PrecomputedSky& sky)
        : sky_(sky),
          settings_(sky.settings_),
          volumeFormat_(settings_.halfFloats ? GL_RGBA16F : GL_RGBA32F),
          progress_("tables of the sky", dispatchesOfVolumes()) {
        const std::vector<gpu::Atmosphere> air = {describeAtmosphere(sky_.atmosphere_)};
        sky_.air_.write("atmosphere", spreadForUniforms(air));
        const std::vector<gpu::PrecomputedSky> sizes = {describe(settings_)};
        sky_.sizes_.write("sizes of the sky's tables", spreadForUniforms(sizes));
    }

    void makeTables() {
        const DebugGroup group("sky tables");
        makeTransmittance(sky_.transmittance_, settings_.transmittance);
        sky_.scattering_ = makeVolume("sky scattering");
        sky_.mie_ = makeVolume("sky Mie scattering");
        if (!settings_.simplified) {
            sky_.irradiance_ = makePlane("sky irradiance", settings_.irradiance);
            orderIrradiance_ = makePlane("sky irradiance of an order", settings_.irradiance);
            makeIrradiance("SKY_DIRECT");
        }
        if (settings_.orders > 1) {
            order_ = makeVolume("sky order");
            density_ = makeVolume("sky density");
        }
        makeSingle();
        for (int order = 2; order <= settings_.orders; ++order) {
            const char* define = order == 2 ? "SKY_FIRST" : "SKY_LATER";
            makeDensity(define);
            makeIrradiance(define);
            makeMultiple();
        }
        timer_.end();
    }

    SkyCost cost() {
        SkyCost cost;
        const SkyTableBytes bytes = skyTableBytes(settings_);
        cost.keptBytes = bytes.kept;
        cost.peakBytes = bytes.peak;
        for (const PassTime& pass : timer_.take()) {
            cost.gpuSeconds += 1e-3 * pass.gpuMs;
        }
        cost.dispatches = dispatches_;
        return cost;
    }

  private:
    bool exact() const { return settings_.exactTexels; }
    int samplesOfSingle() const { return exact() ? kStepsOfExactTexel : kStepsOfRay; }
    int width() const { return settings_.scattering.suns * settings_.scattering.sunAngles; }

    /// Rows of a layer that one dispatch takes.
    int rows(int samples) const {
        const int wanted =
            kSamplesPerDispatch / (samples * width()) / kTexelsOfGroup * kTexelsOfGroup;
        return std::clamp(wanted, kTexelsOfGroup,
                          settings_.scattering.viewAngles + kTexelsOfGroup - 1);
    }
    std::size_t dispatches(int samples) const {
        const int high = settings_.scattering.viewAngles;
        return std::size_t(settings_.scattering.heights) *
               std::size_t((high + rows(samples) - 1) / rows(samples));
    }
    std::size_t dispatchesOfVolumes() const {
        const auto later = std::size_t(settings_.orders - 1);
        return dispatches(samplesOfSingle()) +
               later * (dispatches(kStepsOfRay) + dispatches(kDirections));
    }

    Texture3D makeVolume(const std::string& label) const {
        return Texture3D(label, volumeFormat_,
                         {width(), settings_.scattering.viewAngles, settings_.scattering.heights});
    }

    Program program(const char* name, std::vector<std::string> extra = {}) const {
        std::vector<std::string> all = sky_.defines();
        all.emplace_back(settings_.halfFloats ? "SKY_FORMAT rgba16f" : "SKY_FORMAT rgba32f");
        all.insert(all.end(), extra.begin(), extra.end());
        return Program({std::string("passes/") + name + ".comp"}, all);
    }

    void lookUp(const Texture3D& scattering) const {
        sky_.bind();
        glBindTextureUnit(gpu::kSkyPlaneUnit, orderIrradiance_.name());
        glBindTextureUnit(gpu::kSkyScatteringUnit, scattering.name());
    }

    void finishDispatch() {
        ++dispatches_;
        ++glCounters().drawCalls;
        glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    }

    void overPlane(const Program& pass, const SkyPlaneSize& size) {
        glUseProgram(pass.name());
        glDispatchCompute(workGroups(size.across, kTexelsOfGroup),
                          workGroups(size.heights, kTexelsOfGroup), 1);
        finishDispatch();
    }

    void overVolume(const Program& pass, int samples) {
        const SkyVolumeSize& volume = settings_.scattering;
        glUseProgram(pass.name());
        for (int layer = 0; layer < volume.heights; ++layer) {
            for (int row = 0; row < volume.viewAngles; row += rows(samples)) {
                const int end = std::min(row + rows(samples), volume.viewAngles);
                pass.setInt(gpu::kSkyLayerLocation, layer);
                pass.setInt(gpu::kSkyFirstRowLocation, row);
                pass.setInt(gpu::kSkyEndRowLocation, end);
                glDispatchCompute(workGroups(width(), kTexelsOfGroup),
                                  workGroups(end - row, kTexelsOfGroup), 1);
                finishDispatch();
                // Without this a driver could queue minutes of work.
                glFinish();
                progress_.step();
            }
        }
    }

    void makeTransmittance(Texture2D& table, const SkyPlaneSize& size,
                           const std::vector<std::string>& extra = {}) {
        timer_.begin("transmittance");
        table = makePlane("sky transmittance", size);
        sky_.bind();
        bindImage(gpu::kSkyPlaneImage, table.name(), false, GL_WRITE_ONLY, GL_RGBA32F);
        overPlane(program("sky_transmittance", extra), size);
    }

    void makeSingle() {
        std::vector<std::string> extra;
        if (exact()) {
            extra.emplace_back("SKY_EXACT_TEXELS");
            makeTransmittance(exactTransmittance_, kExactTransmittance, extra);
        }
        timer_.begin("single scattering");
        lookUp(sky_.scattering_);
        if (exact()) {
            glBindTextureUnit(gpu::kSkyTransmittanceUnit, exactTransmittance_.name());
        }
        bindImage(gpu::kSkyScatteringImage, sky_.scattering_.name(), true, GL_WRITE_ONLY,
                  volumeFormat_);
        bindImage(gpu::kSkyMieImage, sky_.mie_.name(), true, GL_WRITE_ONLY, volumeFormat_);
        if (order_) {
            extra.emplace_back("SKY_MORE_ORDERS");
            bindImage(gpu::kSkyOrderImage, order_.name(), true, GL_WRITE_ONLY, volumeFormat_);
        }
        overVolume(program("sky_single", extra), samplesOfSingle());
    }

    void makeDensity(const char* define) {
        timer_.begin("density");
        lookUp(order_);
        bindImage(gpu::kSkyScatteringImage, density_.name(), true, GL_WRITE_ONLY, volumeFormat_);
        overVolume(program("sky_density", {define}), kDirections);
    }

    void makeIrradiance(const char* define) {
        timer_.begin("irradiance");
        lookUp(order_);
        bindImage(gpu::kSkyPlaneImage, orderIrradiance_.name(), false, GL_WRITE_ONLY, GL_RGBA32F);
        bindImage(gpu::kSkyIrradianceImage, sky_.irradiance_.name(), false, GL_READ_WRITE,
                  GL_RGBA32F);
        overPlane(program("sky_irradiance", {define}), settings_.irradiance);
    }

    void makeMultiple() {
        timer_.begin("multiple scattering");
        lookUp(density_);
        bindImage(gpu::kSkyScatteringImage, sky_.scattering_.name(), true, GL_READ_WRITE,
                  volumeFormat_);
        bindImage(gpu::kSkyOrderImage, order_.name(), true, GL_WRITE_ONLY, volumeFormat_);
        overVolume(program("sky_multiple"), kStepsOfRay);
    }

    PrecomputedSky& sky_;
    const PrecomputedSkySettings& settings_;
    GLenum volumeFormat_;
    Texture3D order_;  ///< radiance of the order at hand; of the first, Rayleigh's
    Texture3D density_;
    Texture2D orderIrradiance_;
    Texture2D exactTransmittance_;
    PassTimer timer_;
    int dispatches_ = 0;
    Progress progress_;
};

PrecomputedSky::PrecomputedSky(const Atmosphere& atmosphere, const PrecomputedSkySettings& settings)
    : atmosphere_(atmosphere), settings_(settings) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t cpuStart = std::clock();
    refuseWithoutMemory(settings_);
    Maker maker(*this);
    maker.makeTables();
    cost_ = maker.cost();
    cost_.wallSeconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    cost_.cpuSeconds = double(std::clock() - cpuStart) / CLOCKS_PER_SEC;
}

void PrecomputedSky::bind() const {
    air_.bindUniform(gpu::kAtmosphereSlot, 0);
    sizes_.bindUniform(gpu::kPrecomputedSkySlot, 0);
    glBindTextureUnit(gpu::kSkyTransmittanceUnit, transmittance_.name());
    glBindTextureUnit(gpu::kSkyPlaneUnit, irradiance_.name());
    glBindTextureUnit(gpu::kSkyScatteringUnit, scattering_.name());
    glBindTextureUnit(gpu::kSkyMieUnit, mie_.name());
}

std::vector<std::string> PrecomputedSky::defines() const {
    return settings_.simplified ? std::vector<std::string>{"SKY_2008"} : std::vector<std::string>{};
}

}  // namespace ribalta
