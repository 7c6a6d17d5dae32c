#include "render/sky_textures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <shared/slots.h>

#include "optics/shader_lib.h"
#include "render/describe_atmosphere.h"

namespace ribalta {
namespace {

Texture2D linearTexture(const std::string& label, const Texture2D::Size& size,
                        const std::vector<glm::vec4>& texels) {
    Texture2D texture(label, GL_RGBA32F, size);
    const std::size_t layer = std::size_t(size.width) * std::size_t(size.height);
    for (std::size_t i = 0; i < texels.size() / layer; ++i) {
        texture.write(int(i), GL_FLOAT, &texels[i * layer]);
    }
    texture.setSampling(GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE);
    return texture;
}

/// Optical length past which a level ray's light is no longer smooth enough for one sum: Earth's
/// clean air reaches 19 in blue, which is spread over a greater height than haze.
constexpr double kThickRayleigh = 22.0;
constexpr double kThickMie = 4.0;
/// The same for air that lies so thin over the ground that a ray passes it in a small part of its
/// way.
constexpr double kThinLayer = 1000.0;  // metres, scale height

/// Of a ray that grazes the ground, with H much smaller than R: extinction sqrt(2 pi R H).
double grazing(const glm::dvec3& extinction, double scaleHeight, double radius) {
    return std::max({extinction.x, extinction.y, extinction.z}) *
           std::sqrt(2.0 * std::numbers::pi * radius * scaleHeight);
}

bool isThick(const Atmosphere& air) {
    return std::min(air.rayleighScaleHeightMetres, air.mieScaleHeightMetres) < kThinLayer ||
           grazing(air.rayleighScatteringPerMetre, air.rayleighScaleHeightMetres,
                   air.groundRadiusMetres) > kThickRayleigh ||
           grazing(air.mieExtinctionPerMetre, air.mieScaleHeightMetres, air.groundRadiusMetres) >
               kThickMie;
}

}  // namespace

void SkyTextures::make(const Atmosphere& air, const SkyOrders& orders, const FileCache* files) {
    tables_.emplace(air, orders, files);
    orders_ = orders;
    thick_ = isThick(air);
    const std::vector<gpu::Atmosphere> described = {describeAtmosphere(air)};
    atmosphere_.write("atmosphere", bytesOf(described));
    opticalLengths_ = Texture2D("optical lengths", GL_RG32F,
                                {shader::kLengthCosines, shader::kLengthHeights, 0, 1});
    opticalLengths_.write(0, GL_FLOAT, tables_->opticalLengths().data());
    opticalLengths_.setSampling(GL_NEAREST, GL_NEAREST, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE);
    if (orders.count == 1) {
        rayleighSources_ = {};
        mieSources_ = {};
        groundIrradiance_ = {};
        return;
    }
    const Texture2D::Size size{shader::kSourceSuns, shader::kSourceZeniths,
                               shader::kSourceHeights * shader::kSourceAzimuths, 1};
    rayleighSources_ = linearTexture("Rayleigh sources", size, tables_->rayleighSources());
    mieSources_ = linearTexture("Mie sources", size, tables_->mieSources());
    groundIrradiance_ = linearTexture("ground irradiance", {shader::kSourceSuns, 1, 0, 1},
                                      tables_->groundIrradiance());
}

void SkyTextures::bind() const {
    glBindBufferBase(GL_UNIFORM_BUFFER, gpu::kAtmosphereSlot, atmosphere_.name());
    glBindTextureUnit(gpu::kOpticalLengthsUnit, opticalLengths_.name());
    glBindTextureUnit(gpu::kRayleighSourcesUnit, rayleighSources_.name());
    glBindTextureUnit(gpu::kMieSourcesUnit, mieSources_.name());
    glBindTextureUnit(gpu::kSkyIrradianceUnit, groundIrradiance_.name());
}

std::vector<std::string> SkyTextures::defines() const {
    std::vector<std::string> defines;
    if (orders_.count > 1) {
        defines.emplace_back("SOURCES");
    }
    if (thick_) {
        defines.emplace_back("SKY_PARTS 4");
    }
    return defines;
}

}  // namespace ribalta
