// SkyTextures: the sky's tables on the GPU, kept while air and orders stay the same.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gl/buffer.h"
#include "gl/texture.h"
#include "sky/sky_tables.h"

namespace ribalta {

class SkyTextures {
  public:
    /// Builds and uploads them; `files` as SkyTables takes it. Throws what checked() throws.
    void make(const Atmosphere& air, const SkyOrders& orders, const FileCache* files = nullptr);

    /// Binds the tables and the atmosphere's uniform block.
    void bind() const;
    /// What shaders that include passes/sky_radiance.glsl are compiled with.
    std::vector<std::string> defines() const;
    const SkyTables& tables() const { return *tables_; }

  private:
    SkyOrders orders_;
    bool thick_ = false;
    std::optional<SkyTables> tables_;
    Buffer atmosphere_;
    Texture2D opticalLengths_;
    Texture2D rayleighSources_;
    Texture2D mieSources_;
    Texture2D groundIrradiance_;
};

}  // namespace ribalta
