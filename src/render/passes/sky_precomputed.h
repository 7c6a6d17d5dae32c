// PrecomputedSky: the tables of Bruneton & Neyret's sky, or of its simplified variant, made on the
// GPU for one atmosphere, for all heights and suns. Looked up by passes/sky_precomputed.glsl.
#pragma once

#include <string>
#include <vector>

#include "gl/buffer.h"
#include "gl/texture.h"
#include "gl/texture_3d.h"
#include "render/baseline_sky_settings.h"
#include "scene/atmosphere.h"

namespace ribalta {

class PrecomputedSky {
  public:
    /// Makes all tables, in dispatches none of which keeps a slow machine for long; shows how far
    /// it is. Settings as checked() takes them. Throws Error(kJobFailed) where a table is too
    /// large.
    PrecomputedSky(const Atmosphere& atmosphere, const PrecomputedSkySettings& settings);

    /// Shows shaders the tables and the atmosphere's uniform block.
    void bind() const;
    /// What a shader that includes passes/sky_lookup.glsl has to be compiled with.
    std::vector<std::string> defines() const;
    const Atmosphere& atmosphere() const { return atmosphere_; }
    const SkyCost& cost() const { return cost_; }

  private:
    class Maker;

    Atmosphere atmosphere_;
    PrecomputedSkySettings settings_;
    Buffer air_;
    Buffer sizes_;
    Texture2D transmittance_;
    Texture2D irradiance_;  ///< none where simplified
    Texture3D scattering_;  ///< Rayleigh's single scattering, and all multiple one
    Texture3D mie_;         ///< single scattering
    SkyCost cost_;
};

}  // namespace ribalta
